// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/solve_measure.h"

#include <algorithm>
#include <vector>

#include "cli/bench/statistics.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/nlopt_solver.h"
#include "optimizer_worker/stages/solve_layout.h"

namespace flair::cli {
namespace {

template <typename Message>  // SolvedLayout or EvaluateResponse
Quality QualityOf(const Message& message) {
  Quality quality{message.metrics(), 0, 0, 0};
  for (const v1::EdgeOutcome& edge : message.edge_outcomes()) {
    quality.held += edge.status() == v1::OUTCOME_STATUS_SATISFIED;
    quality.missed += edge.status() == v1::OUTCOME_STATUS_VIOLATED;
    quality.dropped += edge.status() == v1::OUTCOME_STATUS_DROPPED;
  }
  return quality;
}

// The first stage whose account differs; the metrics and outcomes come after all stages.
std::string FirstDifference(const v1::SolvedLayout& a, const v1::SolvedLayout& b) {
  const int count = std::min(a.stage_outcomes_size(), b.stage_outcomes_size());
  for (int i = 0; i < count; ++i) {
    const v1::StageOutcome& stage = a.stage_outcomes(i);
    if (stage.SerializeAsString() != b.stage_outcomes(i).SerializeAsString()) return stage.stage();
  }
  return "report";
}

std::optional<Quality> MeasureRecorded(const BenchProblem& problem, const v1::SolveOptions& options,
                                       const optimizer::Solver& solver) {
  if (!problem.recorded) return std::nullopt;
  v1::EvaluateRequest request;
  request.set_request_id("flair-bench");
  *request.mutable_layout_graph() = problem.graph;
  *request.mutable_placements() = problem.recorded->placements();
  *request.mutable_options() = options;
  const absl::StatusOr<v1::EvaluateResponse> response = optimizer::EvaluateLayout(request, solver);
  if (!response.ok()) return std::nullopt;
  return QualityOf(*response);
}

}  // namespace

int64_t SolveMeasure::restart_count() const {
  int64_t count = 0;
  for (const StageTally& stage : stages) count += stage.restarts;
  return count;
}

int64_t SolveMeasure::evaluation_count() const {
  int64_t count = 0;
  for (const StageTally& stage : stages) count += stage.evaluations;
  return count;
}

double SolveMeasure::CostOf(optimizer::StageKind stage) const {
  double cost = 0;
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) {
    if (outcome.stage() == optimizer::StageName(stage)) cost += outcome.cost();
  }
  return cost;
}

absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats) {
  SolveMeasure measure;
  measure.name = problem.name;
  const optimizer::NloptSolver solver;
  std::vector<double> cpu_s, wall_s;
  std::array<std::vector<double>, kStages.size()> stage_cpu_s;
  for (int i = 0; i < repeats; ++i) {
    const CountingRunner runner;
    const double cpu = ProcessCpu_s(), wall = Wall_s();
    absl::StatusOr<optimizer::SolveResult> result =
        optimizer::SolveLayout(problem.graph, options, solver, nullptr, runner);
    cpu_s.push_back(ProcessCpu_s() - cpu);
    wall_s.push_back(Wall_s() - wall);
    if (!result.ok()) return result.status();
    if (i > 0 && result->layout.SerializeAsString() != measure.layout.SerializeAsString()) {
      return absl::InternalError(
          fmt::format("solve {} of {} gave another layout than the ones before, from stage {} on", i + 1, repeats,
                      FirstDifference(measure.layout, result->layout)));
    }
    measure.layout = std::move(result->layout);
    measure.stages = runner.Tallies();
    for (size_t s = 0; s < kStages.size(); ++s) stage_cpu_s[s].push_back(measure.stages[s].cpu_s);
  }
  measure.cpu_s = Quantile(cpu_s, 0.5);
  measure.wall_s = Quantile(wall_s, 0.5);
  for (size_t s = 0; s < kStages.size(); ++s) measure.stages[s].cpu_s = Quantile(stage_cpu_s[s], 0.5);
  measure.quality = QualityOf(measure.layout);
  measure.recorded = MeasureRecorded(problem, options, solver);
  return measure;
}

}  // namespace flair::cli
