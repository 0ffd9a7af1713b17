// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/stage_call.h"

#include "absl/time/clock.h"
#include "cli/embedded/embedded_services.h"
#include "cli/embedded/remote_stage.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kStageWithin = absl::Minutes(10);

template <typename Service, typename Request, typename Response>
absl::StatusOr<Response> Call(const Request& request, const StageName& name, const std::string& address,
                              orchestrator::StageChannel orchestrator::StageChannels::* stage,
                              grpc::Status (Service::StubInterface::*method)(grpc::ClientContext*, const Request&,
                                                                             Response*)) {
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (address.empty()) {
    absl::StatusOr<std::unique_ptr<EmbeddedServices>> started = EmbeddedServices::StartStages();
    if (!started.ok()) return started.status();
    services = *std::move(started);
    channel = (services->stages().*stage).channel;
  } else {
    absl::StatusOr<std::shared_ptr<grpc::Channel>> made = ConnectToStage(name, address);
    if (!made.ok()) return made.status();
    channel = *std::move(made);
  }
  const std::unique_ptr<typename Service::Stub> stub = Service::NewStub(channel);
  runtime::CallContext call;
  absl::StatusOr<Response> response = runtime::UnaryRequest(*stub, method, request, call, absl::Now() + kStageWithin);
  if (response.ok() || address.empty()) return response;
  return InWords(name, address, response.status());
}

}  // namespace

absl::StatusOr<v1::SolveResponse> CallSolve(const v1::SolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, kOptimizerStage, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Solve);
}

absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, kOptimizerStage, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Resolve);
}

}  // namespace flair::cli
