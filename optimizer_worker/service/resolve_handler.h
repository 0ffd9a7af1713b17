// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::optimizer {

// Answers OptimizerService.Resolve.
class ResolveHandler {
 public:
  // `solver` must outlive the handler.
  explicit ResolveHandler(const Solver& solver) : solver_(solver) {}
  absl::StatusOr<v1::ResolveResponse> Handle(const v1::ResolveRequest& request, runtime::CallContext& call) const;

 private:
  const Solver& solver_;
};

}  // namespace flair::optimizer
