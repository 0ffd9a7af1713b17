// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_stage_restarts.h"

#include "fmt/format.h"
#include "optimizer_worker/stages/pins.h"
#include "optimizer_worker/stages/placements.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {
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
  absl::StatusOr<SolveInput> input = MakeSolveInput(request.layout_graph(), request.options(), solver, cancelled);
  if (!input.ok()) return input.status();
  absl::StatusOr<StageSpec> stage = ReadStage(*input, request);
  if (!stage.ok()) return stage.status();
  PartialLayout before = StartOf(*input);
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

}  // namespace flair::optimizer
