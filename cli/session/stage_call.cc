// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/stage_call.h"

#include "absl/time/clock.h"
#include "cli/embedded/embedded_services.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kStageWithin = absl::Minutes(10);

template <typename Service, typename Request, typename Response>
absl::StatusOr<Response> Call(const Request& request, const std::string& address,
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
    absl::StatusOr<std::shared_ptr<grpc::Channel>> made = runtime::MakeChannel(address, Service::service_full_name());
    if (!made.ok()) return made.status();
    channel = *std::move(made);
  }
  const std::unique_ptr<typename Service::Stub> stub = Service::NewStub(channel);
  runtime::CallContext call;
  absl::StatusOr<Response> response = runtime::UnaryRequest(*stub, method, request, call, absl::Now() + kStageWithin);
  if (address.empty() || !absl::IsUnavailable(response.status())) return response;
  return absl::UnavailableError(
      fmt::format("{}: no {} answers there: {}; is the program running, and is this its port?", address,
                  Service::service_full_name(), std::string(response.status().message())));
}

}  // namespace

absl::StatusOr<v1::SolveResponse> CallSolve(const v1::SolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Solve);
}

absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Resolve);
}

}  // namespace flair::cli
