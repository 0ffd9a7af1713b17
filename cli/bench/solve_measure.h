// SPDX-License-Identifier: GPL-3.0-or-later
// What one problem costs the solver and what comes out.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "cli/bench/counting_runner.h"
#include "cli/bench/problem.h"
#include "flair/v1/layout_metrics.pb.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

// How good a layout is.
struct Quality {
  v1::LayoutMetrics metrics;
  int held = 0;
  int missed = 0;
  // Calls that no term could be made of.
  int dropped = 0;
};

struct SolveMeasure {
  std::string name;
  // Of this process, all threads; medians over the repeats.
  double cpu_s = 0;
  double wall_s = 0;
  // Of all branches, in the order of kStages.
  std::array<StageTally, kStages.size()> stages;
  v1::SolvedLayout layout;
  Quality quality;
  // Of the layout that the problem came with, by the same measures.
  std::optional<Quality> recorded;

  int object_count() const { return layout.graph().object_list().objects_size(); }
  int64_t restart_count() const;
  int64_t evaluation_count() const;
  // Sum of the costs of a stage's outcomes, of the branch that won.
  double CostOf(optimizer::StageKind stage) const;
};

// Solves `repeats` (>= 1) times in this process. INTERNAL when the repeats do not give the same bytes.
absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats);

}  // namespace flair::cli
