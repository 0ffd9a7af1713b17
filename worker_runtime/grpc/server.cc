// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/server.h"

#include <fmt/format.h>
#include <grpcpp/ext/proto_server_reflection_plugin.h>
#include <grpcpp/health_check_service_interface.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server_builder.h>

#include <chrono>
#include <mutex>

#include "flair/v1/worker_service.grpc.pb.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/protocol.h"

namespace flair::runtime {
namespace {

// Both are switches of the whole process that hold for servers built later.
void EnableHealthAndReflectionOnce() {
  static std::once_flag once;
  std::call_once(once, [] {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
  });
}

// Answers without the executor: there is nothing to work on.
class WorkerInfo final : public v1::WorkerService::CallbackService {
 public:
  explicit WorkerInfo(const ServerOptions& options) {
    worker_.set_program(options.program);
    worker_.set_revision(BuildId() + "/" + options.revision);
    worker_.set_build(options.build);
    worker_.add_protocols(kProtocol);
    for (const v1::Capability capability : options.capabilities) worker_.add_capabilities(capability);
    worker_.set_configuration_digest(options.configuration_digest);
  }
  grpc::ServerUnaryReactor* GetWorker(grpc::CallbackServerContext* context, const v1::GetWorkerRequest*,
                                      v1::GetWorkerResponse* response) override {
    *response = worker_;
    grpc::ServerUnaryReactor* reactor = context->DefaultReactor();
    reactor->Finish(grpc::Status::OK);
    return reactor;
  }

 private:
  v1::GetWorkerResponse worker_;
};

absl::Status CheckListenAddress(const std::string& address) {
  if (address.starts_with("unix:") && address.size() > 5) return absl::OkStatus();
  const size_t colon = address.rfind(':');
  const bool has_port = colon != std::string::npos && colon > 0 && colon + 1 < address.size() &&
                        address.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  if (has_port && address.size() - colon <= 6 && std::stoi(address.substr(colon + 1)) <= 65535) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("listen_address \"{}\": expected HOST:PORT with a port in [0, 65535], or unix:PATH", address));
}

}  // namespace

Server::Server(const ServerOptions& options, std::vector<NamedService> services)
    : services_(std::move(services)), max_message_bytes_(MaxMessageBytes(options.max_message_mib)) {
  services_.push_back({v1::WorkerService::service_full_name(), std::make_unique<WorkerInfo>(options)});
}

absl::StatusOr<std::unique_ptr<Server>> Server::Start(const ServerOptions& options,
                                                      std::vector<NamedService> services) {
  std::unique_ptr<Server> server(new Server(options, std::move(services)));
  const std::string& listen = options.listen_address;
  grpc::ServerBuilder builder;
  int port = 0;
  if (!listen.empty()) {
    if (absl::Status status = CheckListenAddress(listen); !status.ok()) return status;
    EnableHealthAndReflectionOnce();
    builder.AddListeningPort(listen, grpc::InsecureServerCredentials(), &port);
  }
  // All our services answer by callback; the threads for others would only wait.
  builder.SetSyncServerOption(grpc::ServerBuilder::NUM_CQS, 1);
  builder.SetSyncServerOption(grpc::ServerBuilder::MAX_POLLERS, 1);
  // Otherwise a second program could take the same port unnoticed and get half of the calls.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  builder.SetMaxReceiveMessageSize(server->max_message_bytes_);
  builder.SetMaxSendMessageSize(server->max_message_bytes_);
  for (const NamedService& service : server->services_) builder.RegisterService(service.service.get());
  server->server_ = builder.BuildAndStart();
  if (server->server_ == nullptr || (!listen.empty() && port == 0)) {
    return absl::UnavailableError(
        fmt::format("cannot listen on {}: the address is in use, not of this machine, or not permitted", listen));
  }
  if (!listen.empty()) {
    server->address_ =
        listen.starts_with("unix:") ? listen : fmt::format("{}:{}", listen.substr(0, listen.rfind(':')), port);
  }
  server->SetServing(true);
  return server;
}

Server::~Server() { Shutdown(absl::ZeroDuration()); }

std::shared_ptr<grpc::Channel> Server::InProcessChannel() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(max_message_bytes_);
  arguments.SetMaxSendMessageSize(max_message_bytes_);
  return server_->InProcessChannel(arguments);
}

void Server::SetServing(bool serving) {
  grpc::HealthCheckServiceInterface* health = server_->GetHealthCheckService();
  if (health == nullptr) return;
  for (const NamedService& service : services_) health->SetServingStatus(service.name, serving);
  health->SetServingStatus(serving);
}

void Server::Shutdown(absl::Duration drain) {
  if (server_ == nullptr) return;
  SetServing(false);
  server_->Shutdown(std::chrono::system_clock::now() + absl::ToChronoMilliseconds(drain));
  server_->Wait();
  server_.reset();
}

}  // namespace flair::runtime
