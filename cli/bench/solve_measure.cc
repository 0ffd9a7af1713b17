// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/solve_measure.h"

#include <sys/resource.h>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "evaluation/metrics/layout_metrics.h"
#include "optimizer_worker/solver/nlopt_solver.h"
#include "optimizer_worker/stages/solve_layout.h"

namespace flair::cli {
namespace {

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

int SolveMeasure::restart_count() const {
  int count = 0;
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) count += stage.restart_count();
  return count;
}

int64_t SolveMeasure::evaluation_count() const {
  int64_t count = 0;
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) count += stage.evaluation_count();
  return count;
}

int SolveMeasure::CountOf(v1::OutcomeStatus status) const {
  return static_cast<int>(std::count_if(layout.edge_outcomes().begin(), layout.edge_outcomes().end(),
                                        [status](const v1::EdgeOutcome& edge) { return edge.status() == status; }));
}

double SolveMeasure::CostOf(const std::string& stage) const {
  double cost = 0;
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) cost += outcome.stage() == stage ? outcome.cost() : 0;
  return cost;
}

absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats) {
  SolveMeasure measure;
  measure.name = problem.name;
  const optimizer::NloptSolver solver;
  std::vector<double> cpu_s, wall_s;
  for (int i = 0; i < repeats; ++i) {
    const double cpu = Seconds(CLOCK_PROCESS_CPUTIME_ID), wall = Seconds(CLOCK_MONOTONIC);
    absl::StatusOr<optimizer::SolveResult> result = optimizer::SolveLayout(problem.graph, options, solver);
    cpu_s.push_back(Seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
    wall_s.push_back(Seconds(CLOCK_MONOTONIC) - wall);
    if (!result.ok()) return result.status();
    measure.layout = std::move(result->layout);
  }
  measure.cpu_s = Quantile(cpu_s, 0.5);
  measure.wall_s = Quantile(wall_s, 0.5);
  if (problem.recorded) {
    absl::StatusOr<v1::LayoutMetrics> recorded = evaluation::MeasureLayout(*problem.recorded);
    if (recorded.ok()) measure.recorded = *std::move(recorded);
  }
  return measure;
}

double PeakMemory_MiB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
}

}  // namespace flair::cli
