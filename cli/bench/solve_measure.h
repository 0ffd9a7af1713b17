// SPDX-License-Identifier: GPL-3.0-or-later
// What one problem costs the solver and what comes out.
#pragma once

#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "cli/bench/problem.h"
#include "flair/v1/layout_metrics.pb.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

struct SolveMeasure {
  std::string name;
  // Of this process, all threads; medians over the repeats.
  double cpu_s = 0;
  double wall_s = 0;
  // The layout, and the measures of the one that the problem came with.
  v1::SolvedLayout layout;
  std::optional<v1::LayoutMetrics> recorded;

  int object_count() const { return layout.graph().object_list().objects_size(); }
  int restart_count() const;
  int64_t evaluation_count() const;
  // Edges with this outcome.
  int CountOf(v1::OutcomeStatus status) const;
  // Sum of the costs of a stage's outcomes, the stages being "primary", "secondary", "polish", "tertiary".
  double CostOf(const std::string& stage) const;
};

// Solves `repeats` (>= 1) times in this process.
absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats);

// The largest memory that this process has held, MiB.
double PeakMemory_MiB();

// The value at `share` of the way through the sorted values; 0 when there are none.
double Quantile(std::vector<double> values, double share);

}  // namespace flair::cli
