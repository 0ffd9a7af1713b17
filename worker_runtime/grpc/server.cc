// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/server.h"

#include <grpc/grpc.h>
#include <grpcpp/impl/codegen/server_callback_handlers.h>
#include <grpcpp/resource_quota.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "flair/v1/worker_service.grpc.pb.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/listener.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

// Answers as soon as a call's headers are there: there is nothing to read and nothing to work on.
class WorkerInfo final : public grpc::Service {
 public:
  explicit WorkerInfo(const ServerOptions& options) {
    worker_.set_program(options.program);
    worker_.set_revision(BuildId() + "/" + options.revision);
    worker_.set_build(options.build);
    worker_.add_protocols(kProtocol);
    for (const v1::Capability capability : options.capabilities) worker_.add_capabilities(capability);
    worker_.set_configuration_digest(options.configuration_digest);
    using grpc::internal::RpcMethod;
    AddMethod(
        new grpc::internal::RpcServiceMethod("/flair.v1.WorkerService/GetWorker", RpcMethod::BIDI_STREAMING, nullptr));
    using Handler = grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, v1::GetWorkerResponse>;
    MarkMethodRawCallback(0, new Handler([this](grpc::CallbackServerContext*) { return new Introduction(worker_); }));
  }

 private:
  class Introduction final : public grpc::ServerBidiReactor<grpc::ByteBuffer, v1::GetWorkerResponse> {
   public:
    explicit Introduction(const v1::GetWorkerResponse& worker) {
      StartWriteAndFinish(&worker, grpc::WriteOptions(), grpc::Status::OK);
    }
    void OnDone() override { delete this; }
  };

  v1::GetWorkerResponse worker_;
};

absl::Status CheckListenAddress(const std::string& address) {
  if (address.starts_with("unix:") && address.size() > 5) return absl::OkStatus();
  if (PortOf(address).has_value()) return absl::OkStatus();
  return InvalidArgument("listen_address \"{}\": expected HOST:PORT with a port in [0, 65535], or unix:PATH", address);
}

// What callers may cost, in connections that are never used, calls that never end and messages that are never taken.
constexpr int kHandshakeTimeoutMs = 10 * 1000;
constexpr int kIdleConnectionMs = 5 * 60 * 1000;
constexpr int kConnectionAgeMs = 60 * 60 * 1000;
constexpr int kCallsOfAConnection = 1024;
constexpr int kMetadataBytes = 16 * 1024;
// Of one connection at a time: while these are parsed, its thread does nothing for others.
constexpr int kReadBytes = 64 * 1024;
// A caller that is not heard of is asked whether it is there; one that asks us more often than this is sent away.
constexpr int kClientKeepaliveMs = 60 * 1000;
constexpr int kClientKeepaliveTimeoutMs = 20 * 1000;
constexpr int kLeastPingIntervalMs = 10 * 1000;
// All messages on their way together. gRPC 1.51 reads a message whole before it looks whether it is too long; with this
// it stops reading, and ends one of the calls that are being read with RESOURCE_EXHAUSTED.
constexpr size_t kLeastMemoryMib = 128;
constexpr size_t kLongestMessagesInMemory = 4;

// How long no call must have been under way before a server that stops leaves its callers: they have been told to go
// elsewhere, and what they sent before they heard of it has arrived.
constexpr std::chrono::milliseconds kLookEvery{10};
constexpr int kQuietLooks = 10;

void LimitCallers(int max_message_mib, grpc::ServerBuilder& builder) {
  const size_t message_mib = static_cast<size_t>(MaxMessageBytes(max_message_mib)) >> 20;
  grpc::ResourceQuota quota("flair");
  quota.Resize(std::max(kLeastMemoryMib, kLongestMessagesInMemory * message_mib) << 20);
  builder.SetResourceQuota(quota);
  const std::pair<const char*, int> limits[] = {
      // Otherwise a second program could take the same socket unnoticed and get half of the calls.
      {GRPC_ARG_ALLOW_REUSEPORT, 0},
      {GRPC_ARG_SERVER_HANDSHAKE_TIMEOUT_MS, kHandshakeTimeoutMs},
      {GRPC_ARG_MAX_CONNECTION_IDLE_MS, kIdleConnectionMs},
      {GRPC_ARG_MAX_CONNECTION_AGE_MS, kConnectionAgeMs},
      {GRPC_ARG_MAX_CONCURRENT_STREAMS, kCallsOfAConnection},
      {GRPC_ARG_MAX_METADATA_SIZE, kMetadataBytes},
      {GRPC_ARG_TCP_MAX_READ_CHUNK_SIZE, kReadBytes},
      {GRPC_ARG_KEEPALIVE_TIME_MS, kClientKeepaliveMs},
      {GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kClientKeepaliveTimeoutMs},
      {GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, kLeastPingIntervalMs}};
  for (const auto& [name, value] : limits) builder.AddChannelArgument(name, value);
}

}  // namespace

Server::Server(const ServerOptions& options, std::vector<NamedService> services)
    : services_(std::move(services)),
      max_message_bytes_(MaxMessageBytes(options.max_message_mib)),
      open_calls_(options.open_calls) {
  services_.push_back({v1::WorkerService::service_full_name(), std::make_unique<WorkerInfo>(options)});
}

absl::Status Server::Listen(const ServerOptions& options, grpc::ServerBuilder& builder) {
  RETURN_IF_ERROR(CheckListenAddress(options.listen_address));
  std::shared_ptr<grpc::ServerCredentials> credentials = grpc::InsecureServerCredentials();
  if (options.tls.has_value()) {
    ASSIGN_OR_RETURN(credentials, MakeServerCredentials(*options.tls));
  }
  std::vector<std::string> names;
  for (const NamedService& service : services_) names.push_back(service.name);
  std::set<std::string> healthy(names.begin(), names.end());
  healthy.insert("");
  auto health = std::make_unique<HealthService>(std::move(healthy));
  health_ = health.get();
  services_.push_back({"", std::move(health)});
  services_.push_back({"", MakeReflectionService(std::move(names))});
  if (options.listen_address.starts_with("unix:")) {
    address_ = options.listen_address;
    builder.AddListeningPort(address_, credentials);
    return absl::OkStatus();
  }
  ASSIGN_OR_RETURN(listener_, Listener::Bind(options.listen_address));
  address_ = listener_->address();
  using Type = grpc::ServerBuilder::experimental_type::ExternalConnectionType;
  acceptor_ = builder.experimental().AddExternalConnectionAcceptor(Type::FROM_FD, credentials);
  return absl::OkStatus();
}

absl::StatusOr<std::unique_ptr<Server>> Server::Start(const ServerOptions& options,
                                                      std::vector<NamedService> services) {
  std::unique_ptr<Server> server(new Server(options, std::move(services)));
  grpc::ServerBuilder builder;
  if (!options.listen_address.empty()) {
    RETURN_IF_ERROR(server->Listen(options, builder));
    LimitCallers(options.max_message_mib, builder);
  }
  // All our services answer by callback; the threads for others would only wait.
  builder.SetSyncServerOption(grpc::ServerBuilder::NUM_CQS, 1);
  builder.SetSyncServerOption(grpc::ServerBuilder::MAX_POLLERS, 1);
  builder.SetMaxReceiveMessageSize(server->max_message_bytes_);
  builder.SetMaxSendMessageSize(server->max_message_bytes_);
  for (const NamedService& service : server->services_) builder.RegisterService(service.service.get());
  server->server_ = builder.BuildAndStart();
  if (server->server_ == nullptr) {
    return Unavailable("cannot listen on {}: the address is in use, not of this machine, or not permitted",
                       options.listen_address);
  }
  if (server->listener_ != nullptr) {
    server->listener_->Start([acceptor = server->acceptor_.get()](int listener, int connection) {
      grpc::experimental::ExternalConnectionAcceptor::NewConnectionParameters parameters;
      parameters.listener_fd = listener;
      parameters.fd = connection;
      acceptor->HandleNewConnection(&parameters);
    });
  }
  return server;
}

Server::~Server() { Shutdown(absl::ZeroDuration()); }

std::shared_ptr<grpc::Channel> Server::InProcessChannel() {
  grpc::ChannelArguments arguments;
  arguments.SetMaxReceiveMessageSize(max_message_bytes_);
  arguments.SetMaxSendMessageSize(max_message_bytes_);
  return server_->InProcessChannel(arguments);
}

// gRPC waits for every connection until its caller has said goodbye, which one that does nothing else does when it
// happens to look at it (gRPC's own: every 5 s) or never.
void Server::CloseIdleConnections(const std::future<void>& stopped) {
  int quiet = 0;
  while (stopped.wait_for(kLookEvery) != std::future_status::ready) {
    quiet = open_calls_ != nullptr && *open_calls_ == 0 ? quiet + 1 : 0;
    if (quiet >= kQuietLooks) grpc_server_cancel_all_calls(server_->c_server());
  }
}

void Server::Shutdown(absl::Duration drain) {
  if (server_ == nullptr) return;
  if (health_ != nullptr) health_->Stop();
  if (listener_ != nullptr) listener_->Stop();
  const auto deadline = std::chrono::system_clock::now() + absl::ToChronoMilliseconds(drain);
  const std::future<void> stopped = std::async(std::launch::async, [this, deadline] { server_->Shutdown(deadline); });
  CloseIdleConnections(stopped);
  stopped.wait();
  server_->Wait();
  server_.reset();
}

}  // namespace flair::runtime
