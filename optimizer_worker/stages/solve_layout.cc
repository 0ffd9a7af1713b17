// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_layout.h"

#include <algorithm>
#include <chrono>

#include "evaluation/metrics/layout_metrics.h"
#include "fmt/format.h"
#include "optimizer_worker/stages/outcomes.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {
namespace {

// How many of the best, distinct primary layouts are furnished to the end.
constexpr size_t kBeam = 3;
// Primary layouts nearer than this (sum over objects) are the same.
constexpr double kSame_m = 0.3;

// One way through the stages so far.
struct Branch {
  PartialLayout state;
  double score = 0;
  std::vector<v1::StageOutcome> outcomes;
  std::vector<absl::Duration> durations;
};

double DistanceOf(const StageSpec& stage, const PartialLayout& a, const PartialLayout& b) {
  double sum = 0;
  for (int object : stage.objects) {
    sum += Distance(Center(a.layout[object]), Center(b.layout[object])) +
           (1 - std::cos(a.layout[object].theta_rad - b.layout[object].theta_rad));
  }
  return sum;
}

// Up to `count` results that differ visibly, best first.
std::vector<size_t> DistinctBest(const StageSpec& stage, const std::vector<RestartResult>& results, size_t count) {
  std::vector<size_t> order(results.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return results[a].score < results[b].score; });
  std::vector<size_t> kept;
  for (size_t i : order) {
    if (kept.size() == count) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](size_t k) {
      return DistanceOf(stage, results[i].state, results[k].state) < kSame_m;
    });
    if (!known) kept.push_back(i);
  }
  return kept;
}

class Driver {
 public:
  Driver(const SolveInput& input, const Progress& progress) : input_(input), progress_(progress) {}

  absl::StatusOr<SolveResult> Run() {
    absl::StatusOr<std::vector<Branch>> branches = Primaries();
    if (!branches.ok()) return branches.status();
    for (Branch& branch : *branches) {
      for (int zone = 0; zone < static_cast<int>(input_.scene.zones.size()); ++zone) {
        if (absl::Status status = Extend(branch, StageKind::kSecondary, zone); !status.ok()) return status;
      }
      if (absl::Status status = Extend(branch, StageKind::kSecondary, -1); !status.ok()) return status;
      if (absl::Status status = Extend(branch, StageKind::kPolish, -1); !status.ok()) return status;
    }
    std::stable_sort(branches->begin(), branches->end(),
                     [](const Branch& a, const Branch& b) { return a.score < b.score; });
    if (absl::Status status = Extend(branches->front(), StageKind::kTertiary, -1); !status.ok()) return status;
    Report(branches->front());
    return MakeResult(*branches);
  }

 private:
  int RestartsOf(const StageSpec& stage) const {
    return input_.settings.max_restarts > 0 ? input_.settings.max_restarts : DefaultRestarts(stage);
  }

  // The account of a stage that ended with `results`, of which `taken` was taken.
  void Record(Branch& branch, const StageSpec& stage, const std::vector<RestartResult>& results, size_t taken,
              absl::Time started) const {
    v1::StageOutcome& outcome = branch.outcomes.emplace_back();
    outcome.set_stage(std::string(StageName(stage.kind)));
    if (stage.zone >= 0) outcome.set_zone_id(input_.scene.zones[stage.zone].id);
    outcome.set_restart_count(static_cast<int>(results.size()));
    outcome.set_best_restart(results[taken].restart);
    int64_t evaluations = 0;
    for (const RestartResult& result : results) evaluations += result.evaluations;
    outcome.set_evaluation_count(evaluations);
    outcome.set_seed(static_cast<int64_t>(RestartSeed(input_.settings, stage, 0)));
    outcome.set_cost(results[taken].score);
    branch.durations.push_back(absl::Now() - started);
    branch.state = results[taken].state;
    branch.score = results[taken].score;
  }

  absl::StatusOr<std::vector<Branch>> Primaries() const {
    const StageSpec stage = MakeStage(input_.scene, StageKind::kPrimary);
    std::vector<Branch> branches;
    if (stage.objects.empty()) {
      branches.push_back({PartialLayout(input_.scene), 0, {}, {}});
      return branches;
    }
    const absl::Time started = absl::Now();
    absl::StatusOr<std::vector<RestartResult>> results =
        RunRestarts(input_, stage, PartialLayout(input_.scene), 0, RestartsOf(stage));
    if (!results.ok()) return results.status();
    for (size_t taken : DistinctBest(stage, *results, kBeam)) {
      Branch& branch = branches.emplace_back(Branch{PartialLayout(input_.scene), 0, {}, {}});
      Record(branch, stage, *results, taken, started);
    }
    return branches;
  }

  absl::Status Extend(Branch& branch, StageKind kind, int zone) const {
    const StageSpec stage = MakeStage(input_.scene, kind, zone);
    if (stage.objects.empty()) return absl::OkStatus();
    const absl::Time started = absl::Now();
    absl::StatusOr<std::vector<RestartResult>> results = RunRestarts(input_, stage, branch.state, 0, RestartsOf(stage));
    if (!results.ok()) return results.status();
    const double floor_score = branch.score;
    Record(branch, stage, *results, BestOf(*results), started);
    if (kind == StageKind::kTertiary) branch.score = floor_score;
    return absl::OkStatus();
  }

  void Report(const Branch& branch) const {
    if (!progress_) return;
    for (const v1::StageOutcome& outcome : branch.outcomes) {
      progress_(outcome.stage(),
                fmt::format("{}{}cost {:.3f} after {} restarts", outcome.zone_id(),
                            outcome.zone_id().empty() ? "" : ": ", outcome.cost(), outcome.restart_count()));
    }
  }

  SolveResult MakeResult(const std::vector<Branch>& branches) const {
    const Branch& best = branches.front();
    SolveResult result;
    v1::SolvedLayout& layout = result.layout;
    *layout.mutable_graph() = input_.graph;
    const SceneCosts costs = BindCosts(input_, ZoneCenters(input_.scene, best.state.placed, best.state.layout));
    for (v1::Placement& placement : MakePlacements(input_, best.state)) *layout.add_placements() = std::move(placement);
    for (v1::ZoneRegion& region : MakeZoneRegions(input_, best.state)) *layout.add_zone_regions() = std::move(region);
    double total = 0;
    for (v1::EdgeOutcome& outcome : EdgeOutcomes(input_, costs, best.state)) {
      total += outcome.weighted_cost();
      *layout.add_edge_outcomes() = std::move(outcome);
    }
    for (v1::TermOutcome& outcome : TermOutcomes(input_, costs, best.state)) {
      total += outcome.cost() * outcome.factor();
      *layout.add_term_outcomes() = std::move(outcome);
    }
    for (const v1::StageOutcome& outcome : best.outcomes) *layout.add_stage_outcomes() = outcome;
    for (size_t i = 1; i < branches.size(); ++i) {
      v1::RunnerUp* runner_up = layout.add_runner_ups();
      runner_up->set_cost(branches[i].score);
      for (v1::Placement& placement : MakePlacements(input_, branches[i].state)) {
        *runner_up->add_placements() = std::move(placement);
      }
    }
    for (v1::Diagnostic& diagnostic : FitDiagnostics(input_, best.state))
      *layout.add_diagnostics() = std::move(diagnostic);
    layout.set_total_cost(total);
    result.stage_durations = best.durations;
    return result;
  }

  const SolveInput& input_;
  const Progress& progress_;
};

absl::Status ReadPlacements(const SolveInput& input,
                            const google::protobuf::RepeatedPtrField<v1::Placement>& placements, PartialLayout& state) {
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& placement = placements[i];
    const int object = input.scene.IndexOf(placement.object_id());
    if (object < 0) {
      return absl::InvalidArgumentError(
          fmt::format("placements[{}].object_id: \"{}\" is not an object of the graph", i, placement.object_id()));
    }
    if (!std::isfinite(placement.x_m()) || !std::isfinite(placement.y_m()) || !std::isfinite(placement.theta_rad())) {
      return absl::InvalidArgumentError(
          fmt::format("placements[{}]: the pose of \"{}\" is not finite", i, placement.object_id()));
    }
    state.Place(object, {placement.x_m(), placement.y_m(), placement.theta_rad()});
  }
  return absl::OkStatus();
}

absl::StatusOr<StageSpec> ReadStage(const SolveInput& input, const v1::SolveRestartsRequest& request) {
  for (StageKind kind : {StageKind::kPrimary, StageKind::kSecondary, StageKind::kPolish, StageKind::kTertiary}) {
    if (request.stage() != StageName(kind)) continue;
    int zone = -1;
    if (kind == StageKind::kSecondary && !request.zone_id().empty()) {
      zone = input.scene.ZoneIndexOf(request.zone_id());
      if (zone < 0) {
        return absl::InvalidArgumentError(fmt::format("zone_id: \"{}\" is not a zone of the graph", request.zone_id()));
      }
    }
    return MakeStage(input.scene, kind, zone);
  }
  return absl::InvalidArgumentError(
      fmt::format("stage: \"{}\" is not one of primary, secondary, polish, tertiary", request.stage()));
}

}  // namespace

absl::StatusOr<SolveResult> SolveLayout(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                        const Solver& solver, const CancelCheck& cancelled, const Progress& progress) {
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, options, solver, cancelled);
  if (!input.ok()) return input.status();
  return Driver(*input, progress).Run();
}

absl::StatusOr<std::vector<v1::RestartOutcome>> SolveStageRestarts(const v1::SolveRestartsRequest& request,
                                                                   const Solver& solver, const CancelCheck& cancelled) {
  if (request.first_restart() < 0 || request.restart_count() < 1 || request.restart_count() > 1000) {
    return absl::InvalidArgumentError(
        fmt::format("first_restart {} and restart_count {}: must be >= 0 and in [1, 1000]", request.first_restart(),
                    request.restart_count()));
  }
  absl::StatusOr<SolveInput> input = MakeSolveInput(request.layout_graph(), request.options(), solver, cancelled);
  if (!input.ok()) return input.status();
  absl::StatusOr<StageSpec> stage = ReadStage(*input, request);
  if (!stage.ok()) return stage.status();
  PartialLayout before(input->scene);
  if (absl::Status status = ReadPlacements(*input, request.placements(), before); !status.ok()) return status;
  for (int object : stage->objects) {
    if (stage->kind != StageKind::kPolish) {
      before.placed[object] = 0;
    } else if (!before.placed[object]) {
      return absl::InvalidArgumentError(
          fmt::format("placements: \"{}\" has none, and stage polish starts from all floor objects",
                      input->scene.objects[object].id));
    }
  }
  absl::StatusOr<std::vector<RestartResult>> results =
      RunRestarts(*input, *stage, before, request.first_restart(), request.restart_count());
  if (!results.ok()) return results.status();
  std::vector<v1::RestartOutcome> outcomes;
  for (const RestartResult& result : *results) {
    v1::RestartOutcome& outcome = outcomes.emplace_back();
    outcome.set_restart(result.restart);
    outcome.set_cost(result.score);
    outcome.set_evaluation_count(result.evaluations);
    PartialLayout moved(input->scene);
    for (int object : stage->objects) moved.Place(object, result.state.layout[object]);
    for (v1::Placement& placement : MakePlacements(*input, moved)) *outcome.add_placements() = std::move(placement);
  }
  return outcomes;
}

absl::StatusOr<v1::EvaluateResponse> EvaluateLayout(const v1::EvaluateRequest& request, const Solver& solver) {
  absl::StatusOr<SolveInput> input = MakeSolveInput(request.layout_graph(), request.options(), solver, nullptr);
  if (!input.ok()) return input.status();
  PartialLayout state(input->scene);
  if (absl::Status status = ReadPlacements(*input, request.placements(), state); !status.ok()) return status;
  const SceneCosts costs = BindCosts(*input, ZoneCenters(input->scene, state.placed, state.layout));
  v1::EvaluateResponse response;
  for (v1::EdgeOutcome& outcome : EdgeOutcomes(*input, costs, state))
    *response.add_edge_outcomes() = std::move(outcome);
  for (v1::TermOutcome& outcome : TermOutcomes(*input, costs, state))
    *response.add_term_outcomes() = std::move(outcome);
  *response.mutable_metrics() = evaluation::MeasureLayout({input->scene, state.layout, state.placed});
  return response;
}

}  // namespace flair::optimizer
