// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/solve_handler.h"

#include "optimizer_worker/fanout/fan_out_runner.h"
#include "optimizer_worker/service/durations.h"
#include "optimizer_worker/service/producer.h"
#include "optimizer_worker/stages/solve_layout.h"

namespace flair::optimizer {
absl::StatusOr<v1::SolveResponse> SolveHandler::Handle(const v1::SolveRequest& request,
                                                       runtime::CallContext& call) const {
  const FanOutRestartRunner runner(peers_, request.options());
  absl::StatusOr<SolveResult> result =
      SolveLayout(request.layout_graph(), request.options(), solver_, [&call] { return call.cancelled(); }, runner);
  if (const absl::Status alive = call.CheckAlive(); !alive.ok()) return alive;
  if (!result.ok()) return result.status();
  v1::SolveResponse response;
  *response.mutable_solved_layout() = std::move(result->layout);
  WriteDurations(result->stage_durations, *response.mutable_stage_durations());
  *response.mutable_producer() = OptimizerProducer();
  return response;
}

}  // namespace flair::optimizer
