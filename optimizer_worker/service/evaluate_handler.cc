// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/evaluate_handler.h"

#include "optimizer_worker/stages/evaluate_layout.h"

namespace flair::optimizer {

absl::StatusOr<v1::EvaluateResponse> EvaluateHandler::Handle(const v1::EvaluateRequest& request,
                                                             runtime::CallContext& call) const {
  if (const absl::Status alive = call.CheckAlive(); !alive.ok()) return alive;
  return EvaluateLayout(request, solver_);
}

}  // namespace flair::optimizer
