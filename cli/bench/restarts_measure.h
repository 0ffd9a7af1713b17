// SPDX-License-Identifier: GPL-3.0-or-later
// How soon restarts of the primary stage find the best layout that many of them find.
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/bench/problem.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

struct RestartsMeasure {
  std::string name;
  // One per restart, in order: where it ended, and the CPU time of its thread.
  std::vector<double> scores;
  std::vector<double> cpu_s;

  double Best() const;
  // Whether restart k ended within 1 % of the best (or 0.001, if that is more).
  bool Hits(size_t k) const;
  // Share of restarts that do.
  double HitShare() const;
};

// Runs restarts 0 to `count` of the stage, one after the other. NOT_FOUND when the room has no primaries.
absl::StatusOr<RestartsMeasure> MeasureRestarts(const BenchProblem& problem, v1::SolveOptions options, int count);

// After how many restarts what share of the rooms has its best primary layout: 1, 2, 4, ... restarts.
std::string RestartsTable(const std::vector<RestartsMeasure>& measures);
std::string RestartsToJson(const std::vector<RestartsMeasure>& measures);

}  // namespace flair::cli
