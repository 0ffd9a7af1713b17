// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::orchestrator {

// Where the workers of a stage are, and how each is reached.
struct StageChannel {
  // To the one worker, of this process say; null when the workers are at `address`. Shared with gRPC, whose stubs keep
  // channels alive so.
  std::shared_ptr<grpc::Channel> channel;
  // Addresses as ParseStageAddresses takes them, when `channel` is null. Error messages name it.
  std::string address = "this process";
  // Where the address is set, such as "stages.optimizer", for error messages.
  std::string setting = "its address";
  // Makes a channel to one of the workers at `address`. `server_name`: whom its certificate must name when it is not
  // the host of the address; empty otherwise.
  std::function<absl::StatusOr<std::shared_ptr<grpc::Channel>>(const std::string& address,
                                                               const std::string& server_name)>
      connect = nullptr;
};

struct StageChannels {
  StageChannel language;
  StageChannel translator;
  StageChannel optimizer;
  StageChannel renderer;
};

// Where a config says that the workers are. INVALID_ARGUMENT names the field. Nothing is connected yet.
absl::StatusOr<StageChannels> ConnectStages(const config::v1::OrchestratorConfig& config);

// Reports bad fields of `stages` and `stage_calls`.
void CheckStageConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::orchestrator
