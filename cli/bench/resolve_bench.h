// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of solved layouts, measured: what one costs, how much it moves, and how good the result is beside a solve from
// nothing of the same problem.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/bench/problem.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

struct ResolveMeasure {
  std::string room;
  // Such as "move desk 1.2 0.5 90".
  std::string edit;
  // Of this process.
  double cpu_s = 0;
  int object_count = 0;
  int moved_count = 0;
  // Constraints that hold: before the edit, after it, and after a solve of the edited graph (-1 when not compared).
  int held_before = 0;
  int held_after = 0;
  int held_anew = -1;
  double deepest_overlap_m = 0;
};

// One edit of each kind per object, at most `per_kind` objects of a room: moved by half a metre, turned, grown by a
// fifth, unpinned after a pin, removed, doubled; and weights raised and edges dropped. Every `compare_every`-th edit is
// compared with a solve from nothing (0: none).
absl::StatusOr<std::vector<ResolveMeasure>> MeasureResolves(const BenchProblem& problem,
                                                            const v1::SolveOptions& options, int per_kind,
                                                            int compare_every);

// A line per room, then medians and 95th percentiles per kind of edit and over all.
std::string ResolveTable(const std::vector<ResolveMeasure>& measures);

}  // namespace flair::cli
