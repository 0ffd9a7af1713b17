// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::optimizer {

// Answers OptimizerService.ListConstraintTypes.
class ListConstraintTypesHandler {
 public:
  absl::StatusOr<v1::ListConstraintTypesResponse> Handle(const v1::ListConstraintTypesRequest& request,
                                                         runtime::CallContext& call) const;
};

}  // namespace flair::optimizer
