// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/resolve_handler.h"

#include "optimizer_worker/resolve/resolve_layout.h"
#include "optimizer_worker/service/durations.h"
#include "optimizer_worker/service/producer.h"

namespace flair::optimizer {

absl::StatusOr<v1::ResolveResponse> ResolveHandler::Handle(const v1::ResolveRequest& request,
                                                           runtime::CallContext& call) const {
  absl::StatusOr<ResolveResult> result = ResolveLayout(request.solved_layout(), request.edits(), request.options(),
                                                       solver_, [&call] { return call.cancelled(); });
  if (const absl::Status alive = call.CheckAlive(); !alive.ok()) return alive;
  if (!result.ok()) return result.status();
  v1::ResolveResponse response;
  *response.mutable_solved_layout() = std::move(result->layout);
  for (std::string& id : result->moved_ids) *response.add_moved_object_ids() = std::move(id);
  WriteDurations(result->stage_durations, *response.mutable_stage_durations());
  *response.mutable_producer() = OptimizerProducer();
  return response;
}

}  // namespace flair::optimizer
