// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/optimizer_worker_config.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/fanout/fan_out.h"
#include "optimizer_worker/solver/solver.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::optimizer {

// The OptimizerService, for flair-optimizer and for programs that host it themselves. `worker` must outlive it.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeOptimizerService(const config::v1::OptimizerWorkerConfig& config,
                                                                    runtime::WorkerContext& worker);

// The requests of OptimizerService, one function each; no gRPC. Errors are those that the protocol states. Thread-safe.

class OptimizerHandlers {
 public:
  // Both must outlive the handlers. `peers` may be empty.
  OptimizerHandlers(const Solver& solver, PeerPool& peers) : solver_(solver), peers_(peers) {}

  absl::StatusOr<v1::ListConstraintTypesResponse> Handle(const v1::ListConstraintTypesRequest& request,
                                                         runtime::CallContext& call) const;
  absl::StatusOr<v1::SolveResponse> Handle(const v1::SolveRequest& request, runtime::CallContext& call) const;
  absl::StatusOr<v1::SolveRestartsResponse> Handle(const v1::SolveRestartsRequest& request,
                                                   runtime::CallContext& call) const;
  absl::StatusOr<v1::ResolveResponse> Handle(const v1::ResolveRequest& request, runtime::CallContext& call) const;
  absl::StatusOr<v1::EvaluateResponse> Handle(const v1::EvaluateRequest& request, runtime::CallContext& call) const;

 private:
  const Solver& solver_;
  PeerPool& peers_;
};

// What peers must have in common, or a layout would depend on who took part: "flair-optimizer slsqp 1, build
// 1a2b3c4d5e6f". Where nobody knows what the program was built from, the linker's id of the program stands for it.
std::string PeerIdentity(const std::string& build);

}  // namespace flair::optimizer
