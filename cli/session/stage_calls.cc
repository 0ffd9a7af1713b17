// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/stage_calls.h"

#include <utility>

#include "absl/time/clock.h"
#include "cli/embedded/embedded_services.h"
#include "cli/embedded/remote_stage.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "optimizer_worker/constraints/registry.h"
#include "renderer_worker/service/make_renderer_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

namespace {

constexpr absl::Duration kWithin = absl::Hours(12);
// An EXR of 3,800 x 3,800 px.
constexpr int kMessageMib = 500;

absl::StatusOr<std::unique_ptr<runtime::InProcessServer>> StartRenderer(const RendererChoice& choice) {
  config::v1::RendererWorkerConfig config;
  // What of a user's models cannot be used is told as they are read.
  config.mutable_runtime()->set_log_level(choice.asset_folder.empty() ? "error" : "warning");
  config.mutable_runtime()->set_max_message_mib(kMessageMib);
  config.set_asset_folder_path(choice.asset_folder);
  if (choice.thread_count > 0) config.set_tracing_thread_count(choice.thread_count);
  return runtime::InProcessServer::Start("flair-renderer", config.runtime(), v1::RendererService::service_full_name(),
                                         [&](runtime::WorkerContext& context) {
                                           context.build = runtime::BuildName();
                                           return renderer::MakeRendererService(config, context);
                                         });
}

}  // namespace

RendererFlags::RendererFlags(CLI::App& command) : Options(command) {
  CLI::Option* renderer = Bind("--renderer HOST:PORT", address, "Use this server instead of one in this process");
  Bind("--assets DIR", asset_folder,
       "Folder of 3D models with a manifest (docs/assets.md), for furniture that one of them fits")
      ->excludes(renderer);
}

absl::StatusOr<std::unique_ptr<RendererClient>> RendererClient::Open(const RendererChoice& choice) {
  std::unique_ptr<RendererClient> client(new RendererClient(choice.address));
  std::shared_ptr<grpc::Channel> channel;
  if (choice.address.empty()) {
    ASSIGN_OR_RETURN(client->server_, StartRenderer(choice));
    channel = client->server_->channel();
  } else {
    ASSIGN_OR_RETURN(channel, ConnectToStage(kRendererStage, choice.address, kMessageMib));
  }
  client->stub_ = v1::RendererService::NewStub(channel);
  return client;
}

absl::Status RendererClient::Explain(const absl::Status& status) const {
  return address_.empty() ? status : InWords(kRendererStage, address_, status);
}

template <typename Request, typename Response>
absl::StatusOr<Response> RendererClient::Ask(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                                          Response*),
                                             const Request& request) {
  runtime::CallContext call;
  absl::StatusOr<Response> response = runtime::UnaryRequest(*stub_, method, request, call, absl::Now() + kWithin);
  if (!response.ok()) return Explain(response.status());
  return response;
}

absl::StatusOr<v1::RenderResponse> RendererClient::Render(const v1::RenderRequest& request) {
  return Ask(&Stub::Render, request);
}

absl::StatusOr<v1::ExportSceneResponse> RendererClient::ExportScene(const v1::ExportSceneRequest& request) {
  return Ask(&Stub::ExportScene, request);
}

std::unique_ptr<ContactSheetCall> RendererClient::ComposeContactSheet(const v1::ContactSheetOptions& options) {
  return std::make_unique<ContactSheetCall>(*this, options);
}

ContactSheetCall::ContactSheetCall(RendererClient& client, const v1::ContactSheetOptions& options) : client_(client) {
  context_.set_deadline(absl::ToChronoTime(absl::Now() + kWithin));
  writer_ = client.stub_->ComposeContactSheet(&context_, &response_);
  v1::ComposeContactSheetRequest first;
  *first.mutable_options() = options;
  writer_->Write(first);
}

bool ContactSheetCall::Add(v1::ContactSheetTile tile) {
  v1::ComposeContactSheetRequest request;
  *request.mutable_tile() = std::move(tile);
  return writer_->Write(request);
}

absl::StatusOr<v1::ComposeContactSheetResponse> ContactSheetCall::Finish() {
  writer_->WritesDone();
  const grpc::Status status = writer_->Finish();
  if (!status.ok()) return client_.Explain(runtime::FromGrpcStatus(status));
  return std::move(response_);
}

namespace {

constexpr absl::Duration kStageWithin = absl::Minutes(10);

template <typename Service, typename Request, typename Response>
absl::StatusOr<Response> Call(const Request& request, const StageName& name, const std::string& address,
                              orchestrator::StageChannel orchestrator::StageChannels::*stage,
                              grpc::Status (Service::StubInterface::*method)(grpc::ClientContext*, const Request&,
                                                                             Response*)) {
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (address.empty()) {
    ASSIGN_OR_RETURN(services, EmbeddedServices::StartStages());
    channel = (services->stages().*stage).channel;
  } else {
    ASSIGN_OR_RETURN(channel, ConnectToStage(name, address));
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

absl::StatusOr<v1::ConstraintCatalog> CallListConstraintTypes(const std::string& address) {
  if (address.empty()) return optimizer::MakeCatalog();
  ASSIGN_OR_RETURN(v1::ListConstraintTypesResponse response,
                   Call<v1::OptimizerService>(v1::ListConstraintTypesRequest(), kOptimizerStage, address,
                                              &orchestrator::StageChannels::optimizer,
                                              &v1::OptimizerService::StubInterface::ListConstraintTypes));
  return std::move(*response.mutable_catalog());
}

absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address) {
  return Call<v1::OptimizerService>(request, kOptimizerStage, address, &orchestrator::StageChannels::optimizer,
                                    &v1::OptimizerService::StubInterface::Resolve);
}

}  // namespace flair::cli
