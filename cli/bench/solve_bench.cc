// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <mutex>

#include "cli/bench/bench.h"
#include "cli/output/message_view.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr std::array kStages = {optimizer::StageKind::kPrimary, optimizer::StageKind::kSecondary,
                                optimizer::StageKind::kPolish, optimizer::StageKind::kTertiary};

std::string NameOf(optimizer::StageKind stage) { return std::string(optimizer::StageName(stage)); }

struct StageTally {
  int64_t restarts = 0;
  int64_t evaluations = 0;
  // CPU time of the threads that called; all of it when the solve has one thread.
  double cpu_s = 0;
};
using StageTallies = std::array<StageTally, kStages.size()>;

// Runs restarts on this process's threads and counts them by stage. Thread-safe.
class CountingRunner final : public optimizer::RestartRunner {
 public:
  absl::StatusOr<std::vector<optimizer::RestartResult>> Run(const optimizer::SolveInput& input,
                                                            const optimizer::StageSpec& stage,
                                                            const optimizer::PartialLayout& before, int first,
                                                            int count) const override {
    const double started = ThreadCpu_s();
    absl::StatusOr<std::vector<optimizer::RestartResult>> results = local_.Run(input, stage, before, first, count);
    const double cpu_s = ThreadCpu_s() - started;
    if (!results.ok()) return results;
    const std::lock_guard lock(mutex_);
    StageTally& tally = tallies_[static_cast<size_t>(stage.kind)];
    tally.cpu_s += cpu_s;
    tally.restarts += static_cast<int64_t>(results->size());
    for (const optimizer::RestartResult& result : *results) tally.evaluations += result.evaluations;
    return results;
  }
  // In the order of kStages. After the solve.
  const StageTallies& tallies() const { return tallies_; }

 private:
  const optimizer::LocalRestartRunner local_;
  mutable std::mutex mutex_;
  mutable StageTallies tallies_;
};

// Measures of a layout that are told, by their names in LayoutMetrics.
constexpr const char* kMetrics[] = {"oob_percent",           "oor_percent",    "deepest_overlap_m",
                                    "oob_3d_percent",        "oor_3d_percent", "reachable_floor_share",
                                    "reachable_front_share", "pathway_cost_m3"};

// Verdicts and measures of a SolvedLayout or an EvaluateResponse.
template <typename Message>
Record QualityOf(const Message& message) {
  const auto count = [&message](v1::OutcomeStatus status) {
    return std::ranges::count(message.edge_outcomes(), status, &v1::EdgeOutcome::status);
  };
  // Dropped are calls that no term could be made of.
  Record quality{{"held", count(v1::OUTCOME_STATUS_SATISFIED)},
                 {"missed", count(v1::OUTCOME_STATUS_VIOLATED)},
                 {"dropped", count(v1::OUTCOME_STATUS_DROPPED)}};
  const v1::LayoutMetrics& metrics = message.metrics();
  for (const char* const name : kMetrics) {
    quality[name] = metrics.GetReflection()->GetDouble(metrics, metrics.GetDescriptor()->FindFieldByName(name));
  }
  quality["use_count"] = metrics.use_count();
  quality["met_use_count"] = metrics.met_use_count();
  quality["findings"] = Record::array();
  for (const v1::Finding& finding : metrics.findings()) {
    quality["findings"].push_back({{"kind", EnumInWords(finding.kind())}, {"message", finding.message()}});
  }
  return quality;
}

// The layout that the problem came with, by our own measures.
void MeasureRecorded(const BenchProblem& problem, const v1::SolveOptions& options, const optimizer::Solver& solver,
                     Record& record) {
  if (!problem.recorded) return;
  v1::EvaluateRequest request;
  request.set_request_id("flair-bench");
  *request.mutable_layout_graph() = problem.graph;
  *request.mutable_placements() = problem.recorded->placements();
  *request.mutable_options() = options;
  const absl::StatusOr<v1::EvaluateResponse> response = optimizer::EvaluateLayout(request, solver);
  if (response.ok()) record["recorded"] = QualityOf(*response);
}

// The constraints that do not hold, and why.
Record MissedOf(const v1::SolvedLayout& layout) {
  Record missed = Record::array();
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    const v1::EdgeOutcome& edge = layout.edge_outcomes(i);
    if (edge.status() != v1::OUTCOME_STATUS_VIOLATED) continue;
    missed.push_back({{"edge", edge.edge_id()},
                      {"type", layout.graph().edges(i).type()},
                      {"cost", edge.cost()},
                      {"reason", edge.reason()}});
  }
  return missed;
}

// Sum of the costs of a stage's outcomes, of the branch that won.
double CostOf(const v1::SolvedLayout& layout, const std::string& stage) {
  double cost = 0;
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) {
    if (outcome.stage() == stage) cost += outcome.cost();
  }
  return cost;
}

// `stage_cpu_s` of each repeat; all else is the same in all of them.
Record StagesOf(const v1::SolvedLayout& layout, const StageTallies& tallies,
                const std::array<std::vector<double>, kStages.size()>& stage_cpu_s) {
  Record stages;
  for (size_t s = 0; s < kStages.size(); ++s) {
    stages[NameOf(kStages[s])] = {{"cost", CostOf(layout, NameOf(kStages[s]))},
                                  {"restarts", tallies[s].restarts},
                                  {"evaluations", tallies[s].evaluations},
                                  {"cpu_s", Quantile(stage_cpu_s[s], 0.5)}};
  }
  return stages;
}

}  // namespace

absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats) {
  SolveMeasure measure;
  const double memory_before_MiB = PeakMemory_MiB();
  const optimizer::NloptSolver solver;
  std::vector<double> cpu_s, wall_s;
  std::array<std::vector<double>, kStages.size()> stage_cpu_s;
  StageTallies tallies;
  for (int i = 0; i < repeats; ++i) {
    const CountingRunner runner;
    const double cpu = ProcessCpu_s(), wall = Wall_s();
    absl::StatusOr<optimizer::SolveResult> result =
        optimizer::SolveLayout(problem.graph, options, solver, nullptr, runner);
    cpu_s.push_back(ProcessCpu_s() - cpu);
    wall_s.push_back(Wall_s() - wall);
    if (!result.ok()) return result.status();
    if (i > 0 && result->layout.SerializeAsString() != measure.layout.SerializeAsString()) {
      return Internal("solve {} of {} gave another layout than the ones before", i + 1, repeats);
    }
    measure.layout = std::move(result->layout);
    tallies = runner.tallies();
    for (size_t s = 0; s < kStages.size(); ++s) stage_cpu_s[s].push_back(tallies[s].cpu_s);
  }
  int64_t restarts = 0, evaluations = 0;
  for (const StageTally& tally : tallies) {
    restarts += tally.restarts;
    evaluations += tally.evaluations;
  }
  measure.record = {{"name", problem.name},
                    {"objects", problem.graph.object_list().objects_size()},
                    {"cpu_s", Quantile(cpu_s, 0.5)},
                    {"wall_s", Quantile(wall_s, 0.5)},
                    {"restarts", restarts},
                    {"evaluations", evaluations},
                    {"total_cost", measure.layout.total_cost()},
                    {"stages", StagesOf(measure.layout, tallies, stage_cpu_s)},
                    {"memory_mib", {{"before", memory_before_MiB}, {"after", PeakMemory_MiB()}}},
                    {"ours", QualityOf(measure.layout)}};
  MeasureRecorded(problem, options, solver, measure.record);
  measure.record["missed"] = MissedOf(measure.layout);
  return measure;
}

}  // namespace flair::cli
