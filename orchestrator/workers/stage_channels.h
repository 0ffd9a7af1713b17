// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::orchestrator {

// Where a stage's workers are, as its setting says: addresses with commas between.
struct StageAddresses {
  // "HOST:PORT" and "unix:PATH": a worker each.
  std::vector<std::string> workers;
  // Of "dns:///NAME:PORT": a worker at every address of the name.
  struct Name {
    std::string host;
    int port = 0;
  };
  std::vector<Name> names;
};

// INVALID_ARGUMENT names the part that has no such form.
absl::StatusOr<StageAddresses> ParseStageAddresses(const std::string& text);

// The addresses of a name, numeric: "10.0.0.7" or "fd00::7". UNAVAILABLE says why there are none. A function so that
// tests need no name server. May take seconds.
using Lookup = std::function<absl::StatusOr<std::vector<std::string>>(const std::string& host)>;

// Asks the system (getaddrinfo).
absl::StatusOr<std::vector<std::string>> LookUpHost(const std::string& host);

// "10.0.0.7:50053" or "[fd00::7]:50053".
std::string JoinHostPort(const std::string& host, int port);

// Makes a channel to one worker. `server_name`: whom its certificate must name when that is not the host of the
// address; empty otherwise.
using ConnectWorker = std::function<absl::StatusOr<std::shared_ptr<grpc::Channel>>(const std::string& address,
                                                                                   const std::string& server_name)>;

// Where the workers of a stage are, and how each is reached.
struct StageChannel {
  // To the one worker, of this process say, when there is no `connect`. Shared with gRPC, whose stubs keep channels
  // alive so.
  std::shared_ptr<grpc::Channel> channel;
  // Addresses as ParseStageAddresses takes them, when there is `connect`. Error messages name it.
  std::string address = "this process";
  // Where the address is set, such as "stages.optimizer", for error messages.
  std::string setting = "its address";
  // Reaches each worker at `address`.
  ConnectWorker connect = nullptr;
};

struct StageChannels {
  StageChannel language;
  StageChannel translator;
  StageChannel optimizer;
  StageChannel renderer;
};

// Reaches workers that serve `service` (full name); they are READY while they say that they serve.
ConnectWorker ConnectorTo(const std::string& service, const runtime::ChannelOptions& options);

// Where a config says that the workers are. INVALID_ARGUMENT names the field. Nothing is connected yet.
absl::StatusOr<StageChannels> ConnectStages(const config::v1::OrchestratorConfig& config);

// Reports bad fields of `stages` and `stage_calls`.
void CheckStageConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::orchestrator
