// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/make_optimizer_service.h"

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/fanout/grpc_peer.h"
#include "optimizer_worker/service/evaluate_handler.h"
#include "optimizer_worker/service/list_constraint_types_handler.h"
#include "optimizer_worker/service/producer.h"
#include "optimizer_worker/service/resolve_handler.h"
#include "optimizer_worker/service/solve_handler.h"
#include "optimizer_worker/service/solve_metrics.h"
#include "optimizer_worker/service/solve_restarts_handler.h"
#include "optimizer_worker/solver/nlopt_solver.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/logging/log.h"

namespace flair::optimizer {
namespace {

class Service final : public v1::OptimizerService::CallbackService {
 public:
  Service(runtime::WorkerContext& worker, std::vector<std::unique_ptr<PeerOptimizer>> peers)
      : worker_(worker),
        identity_(PeerIdentity(worker.build)),
        peers_(std::move(peers), worker.clock,
               [&worker](const std::string& remark) { worker.logger->warn("{}", remark); }) {}

  grpc::ServerUnaryReactor* ListConstraintTypes(grpc::CallbackServerContext* context,
                                                const v1::ListConstraintTypesRequest* request,
                                                v1::ListConstraintTypesResponse* response) override {
    return runtime::ServeUnary(worker_, "ListConstraintTypes", context, request, response, list_constraint_types_);
  }
  grpc::ServerUnaryReactor* Solve(grpc::CallbackServerContext* context, const v1::SolveRequest* request,
                                  v1::SolveResponse* response) override {
    return runtime::ServeUnary(worker_, "Solve", context, request, response, counted_solve_);
  }
  grpc::ServerUnaryReactor* SolveRestarts(grpc::CallbackServerContext* context, const v1::SolveRestartsRequest* request,
                                          v1::SolveRestartsResponse* response) override {
    context->AddInitialMetadata(kProducerMetadata, identity_);
    return runtime::ServeUnary(worker_, "SolveRestarts", context, request, response, counted_solve_restarts_);
  }
  grpc::ServerUnaryReactor* Resolve(grpc::CallbackServerContext* context, const v1::ResolveRequest* request,
                                    v1::ResolveResponse* response) override {
    return runtime::ServeUnary(worker_, "Resolve", context, request, response, resolve_);
  }
  grpc::ServerUnaryReactor* Evaluate(grpc::CallbackServerContext* context, const v1::EvaluateRequest* request,
                                     v1::EvaluateResponse* response) override {
    return runtime::ServeUnary(worker_, "Evaluate", context, request, response, evaluate_);
  }

 private:
  runtime::WorkerContext& worker_;
  const std::string identity_;
  const NloptSolver solver_;
  ListConstraintTypesHandler list_constraint_types_;
  PeerPool peers_;
  SolveHandler solve_{solver_, peers_};
  SolveRestartsHandler solve_restarts_{solver_};
  ResolveHandler resolve_{solver_};
  EvaluateHandler evaluate_{solver_};
  const SolveMetrics metrics_{worker_.metrics};
  runtime::ObservedHandler<SolveHandler, const SolveMetrics&> counted_solve_{solve_, worker_.clock, metrics_};
  runtime::ObservedHandler<SolveRestartsHandler, const SolveMetrics&> counted_solve_restarts_{solve_restarts_,
                                                                                              worker_.clock, metrics_};
};

}  // namespace

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeOptimizerService(const config::v1::OptimizerWorkerConfig& config,
                                                                    runtime::WorkerContext& worker) {
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  for (int i = 0; i < config.peer_addresses_size(); ++i) {
    absl::StatusOr<std::unique_ptr<PeerOptimizer>> peer =
        MakeGrpcPeer(config.peer_addresses(i), PeerIdentity(worker.build), worker.clock,
                     runtime::ChannelOptionsOf(config.runtime()));
    if (!peer.ok()) {
      return absl::InvalidArgumentError(fmt::format("peer_addresses[{}]: {}", i, std::string(peer.status().message())));
    }
    peers.push_back(*std::move(peer));
  }
  worker.capabilities = {v1::CAPABILITY_DETERMINISTIC, v1::CAPABILITY_EVALUATE, v1::CAPABILITY_RESOLVE,
                         v1::CAPABILITY_SOLVE_RESTARTS, v1::CAPABILITY_VARIANTS};
  return std::make_unique<Service>(worker, std::move(peers));
}

}  // namespace flair::optimizer
