// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/fanout/peer_pool.h"
#include "optimizer_worker/solver/solver.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::optimizer {

// Answers OptimizerService.Solve.
class SolveHandler {
 public:
  // Both must outlive the handler. `peers` may be empty.
  SolveHandler(const Solver& solver, PeerPool& peers) : solver_(solver), peers_(peers) {}
  absl::StatusOr<v1::SolveResponse> Handle(const v1::SolveRequest& request, runtime::CallContext& call) const;

 private:
  const Solver& solver_;
  PeerPool& peers_;
};

}  // namespace flair::optimizer
