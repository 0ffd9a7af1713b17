// SPDX-License-Identifier: GPL-3.0-or-later
// Another optimizer that runs restarts for this one.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::optimizer {

class PeerOptimizer {
 public:
  virtual ~PeerOptimizer() = default;
  // For logs.
  virtual const std::string& name() const = 0;
  // OptimizerService.SolveRestarts; waits for the answer, which is not checked. CANCELLED soon after `cancellation` was
  // asked for. Thread-safe.
  virtual absl::StatusOr<v1::SolveRestartsResponse> SolveRestarts(const v1::SolveRestartsRequest& request,
                                                                  runtime::Cancellation& cancellation) = 0;
};

}  // namespace flair::optimizer
