// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/evaluate_handler.h"

#include "optimizer_worker/stages/evaluate_layout.h"
#include "room/validation/validate.h"

namespace flair::optimizer {

absl::StatusOr<v1::EvaluateResponse> EvaluateHandler::Handle(const v1::EvaluateRequest& request,
                                                             runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  if (const absl::Status alive = call.CheckAlive(); !alive.ok()) return alive;
  return EvaluateLayout(request, solver_);
}

}  // namespace flair::optimizer
