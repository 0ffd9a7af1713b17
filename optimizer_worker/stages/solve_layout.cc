// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_layout.h"

#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/measures.h"
#include "fmt/format.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {

absl::StatusOr<SolveResult> SolveLayout(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                        const Solver& solver, const CancelCheck& cancelled,
                                        const RestartRunner& runner) {
  ASSIGN_OR_RETURN(SolveInput input, MakeSolveInput(graph, options, solver, cancelled));
  if (input.settings.groups) input.groups = FindGroups(input);
  ASSIGN_OR_RETURN(std::vector<Branch> branches, Driver(input, runner).Run());
  ASSIGN_OR_RETURN(std::vector<Branch> fitting, SolveWithoutMisfits(input, runner, branches));
  if (input.Cancelled()) return absl::CancelledError("cancelled when all was placed");
  // Placing the misfits last may find room for all of them; when it does not, the policy decides.
  if (input.settings.leave_out_misfits) {
    branches = std::move(fitting);
  } else if (fitting.front().left_out.empty()) {
    branches.front() = std::move(fitting.front());
  }
  ASSIGN_OR_RETURN(branches, SolveWithoutBadSpares(input, runner, std::move(branches)));
  return SolveResult{MakeSolvedLayout(input, branches), branches.front().durations};
}

absl::StatusOr<v1::EvaluateResponse> EvaluateLayout(const v1::EvaluateRequest& request, const Solver& solver) {
  ASSIGN_OR_RETURN(SolveInput input, MakeSolveInput(request.layout_graph(), request.options(), solver, nullptr));
  PartialLayout state(input.scene);
  RETURN_IF_ERROR(ReadPlacements(input, request.placements(), state));
  const SceneCosts costs = BindCosts(input, state);
  v1::EvaluateResponse response;
  for (v1::EdgeOutcome& outcome : EdgeOutcomes(input, costs, state)) *response.add_edge_outcomes() = std::move(outcome);
  for (v1::TermOutcome& outcome : TermOutcomes(input, costs, state)) *response.add_term_outcomes() = std::move(outcome);
  *response.mutable_metrics() = evaluation::MeasureLayout({input.scene, state.layout, state.placed});
  evaluation::AddUses(input.graph, request.placements(), response.edge_outcomes(), *response.mutable_metrics());
  return response;
}

namespace {

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
    return FreeStage(input, kind, zone);
  }
  return absl::InvalidArgumentError(
      fmt::format("stage: \"{}\" is not one of primary, secondary, polish, tertiary", request.stage()));
}

}  // namespace

absl::StatusOr<std::vector<v1::RestartOutcome>> SolveStageRestarts(const v1::SolveRestartsRequest& request,
                                                                   const Solver& solver, const CancelCheck& cancelled) {
  if (request.first_restart() < 0 || request.restart_count() < 1 || request.restart_count() > 1000) {
    return absl::InvalidArgumentError(
        fmt::format("first_restart {} and restart_count {}: must be >= 0 and in [1, 1000]", request.first_restart(),
                    request.restart_count()));
  }
  ASSIGN_OR_RETURN(SolveInput input, MakeSolveInput(request.layout_graph(), request.options(), solver, cancelled));
  if (input.settings.groups) input.groups = FindGroups(input);
  ASSIGN_OR_RETURN(StageSpec stage, ReadStage(input, request));
  PartialLayout before = StartOf(input);
  RETURN_IF_ERROR(ReadPlacements(input, request.placements(), before));
  for (int object : stage.objects) {
    if (stage.kind != StageKind::kPolish) {
      before.placed[object] = 0;
    } else if (!before.placed[object]) {
      return absl::InvalidArgumentError(
          fmt::format("placements: \"{}\" has none, and stage polish starts from all floor objects",
                      input.scene.objects[object].id));
    }
  }
  ASSIGN_OR_RETURN(const std::vector<RestartResult> results,
                   RunRestarts(input, stage, before, request.first_restart(), request.restart_count()));
  std::vector<v1::RestartOutcome> outcomes;
  for (const RestartResult& result : results) {
    v1::RestartOutcome& outcome = outcomes.emplace_back();
    outcome.set_restart(result.restart);
    outcome.set_cost(result.score);
    outcome.set_evaluation_count(result.evaluations);
    PartialLayout moved(input.scene);
    for (int object : stage.objects) moved.Place(object, result.state.layout[object]);
    for (v1::Placement& placement : MakePlacements(input, moved)) *outcome.add_placements() = std::move(placement);
  }
  return outcomes;
}

}  // namespace flair::optimizer
