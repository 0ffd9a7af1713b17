// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/solve_restarts_handler.h"

#include "optimizer_worker/stages/solve_stage_restarts.h"

namespace flair::optimizer {

absl::StatusOr<v1::SolveRestartsResponse> SolveRestartsHandler::Handle(const v1::SolveRestartsRequest& request,
                                                                       runtime::CallContext& call) const {
  absl::StatusOr<std::vector<v1::RestartOutcome>> outcomes =
      SolveStageRestarts(request, solver_, [&call] { return call.cancelled(); });
  if (const absl::Status alive = call.CheckAlive(); !alive.ok()) return alive;
  if (!outcomes.ok()) return outcomes.status();
  v1::SolveRestartsResponse response;
  for (v1::RestartOutcome& outcome : *outcomes) *response.add_outcomes() = std::move(outcome);
  return response;
}

}  // namespace flair::optimizer
