// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::orchestrator {

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
