// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>
#include <grpcpp/impl/codegen/service_type.h>
#include <grpcpp/impl/service_type.h>

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "flair/v1/worker_service.pb.h"

namespace grpc {
class Server;
class ServerBuilder;
namespace experimental {
class ExternalConnectionAcceptor;
}  // namespace experimental
}  // namespace grpc

namespace flair::runtime {

class HealthService;
class Listener;

// A service and the full name under which its health is reported, such as "flair.v1.OptimizerService".
struct NamedService {
  std::string name;
  std::unique_ptr<grpc::Service> service;
};

struct ServerOptions {
  // Name of the program, the data it answers from, what it was built from and what it promises: what WorkerService
  // answers.
  std::string program;
  std::string revision;
  std::string build;
  std::vector<v1::Capability> capabilities;
  std::string configuration_digest;
  // "HOST:PORT" or "unix:PATH"; port 0 takes a free one. Empty: no port, in-process channels only.
  std::string listen_address;
  // Largest message in MiB; 32 when 0.
  int max_message_mib = 0;
  // Unset: plain text.
  std::optional<config::v1::TlsConfig> tls = std::nullopt;
  // How many calls are not over: with none, a stop waits for no connection. Null: it waits for every connection.
  std::shared_ptr<const std::atomic<int>> open_calls = nullptr;
};

// A running gRPC server that owns its services. What callers may cost it is limited: connections (ConnectionGate),
// calls of one connection, the memory of messages on their way, and the time to begin or to say nothing; see
// docs/security.md. Serves WorkerService beside them. A listening one answers health (per service name and for "") and
// reflection. Thread-safe.
class Server {
 public:
  // INVALID_ARGUMENT for an address of no known form, UNAVAILABLE when it cannot be bound.
  static absl::StatusOr<std::unique_ptr<Server>> Start(const ServerOptions& options,
                                                       std::vector<NamedService> services);

  // As Shutdown without drain.
  ~Server();

  // Where it listens, with the port chosen, such as "127.0.0.1:43211"; empty when in-process only.
  const std::string& address() const { return address_; }

  // A channel that needs no port. Must not be used after Shutdown.
  std::shared_ptr<grpc::Channel> InProcessChannel();

  // Reports NOT_SERVING, takes no more connections and calls, gives running ones (open_calls) `drain`, then cancels
  // them and waits until they have ended. Connections without such calls are closed: their callers are told to go
  // elsewhere, and have a moment to do so. May be called more than once.
  void Shutdown(absl::Duration drain);

 private:
  Server(const ServerOptions& options, std::vector<NamedService> services);
  absl::Status Listen(const ServerOptions& options, grpc::ServerBuilder& builder);
  // Until `stopped` or, when only idle connections are left, closes these.
  void CloseIdleConnections(const std::future<void>& stopped);

  std::vector<NamedService> services_;
  // One of them; null without a port.
  HealthService* health_ = nullptr;
  const int max_message_bytes_;
  const std::shared_ptr<const std::atomic<int>> open_calls_;
  std::unique_ptr<grpc::Server> server_;
  // gRPC's end of the listener, and the listener: null without a TCP port. The listener goes first.
  std::unique_ptr<grpc::experimental::ExternalConnectionAcceptor> acceptor_;
  std::unique_ptr<Listener> listener_;
  std::string address_;
};

// Serves grpc.health.v1.Health: services of these names are SERVING until Stop. gRPC's own copies messages, however
// large, before it looks at them. Thread-safe.
class HealthService final : public grpc::Service {
 public:
  explicit HealthService(std::set<std::string> names);

  // From now on all are NOT_SERVING; who watches is told.
  void Stop();

 private:
  struct State;
  class Call;
  const std::shared_ptr<State> state_;
};

// Serves grpc.reflection.v1alpha.ServerReflection, by which tools learn the services of these names and their messages.
// gRPC's own makes of a message whatever it is sent: gigabytes of 30 MiB.
std::unique_ptr<grpc::Service> MakeReflectionService(std::vector<std::string> service_names);

}  // namespace flair::runtime
