// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"

namespace flair::orchestrator {

// A channel to one stage, and its address and where that is set, which error messages name.
struct StageChannel {
  // Shared with gRPC, whose stubs keep channels alive so.
  std::shared_ptr<grpc::Channel> channel;
  std::string address = "this process";
  std::string setting = "its address";  // such as "stages.optimizer"
};

struct StageChannels {
  StageChannel language;
  StageChannel translator;
  StageChannel optimizer;
  StageChannel renderer;
};

// Channels to the addresses of a config. INVALID_ARGUMENT names the field.
absl::StatusOr<StageChannels> ConnectStages(const config::v1::OrchestratorConfig& config);

}  // namespace flair::orchestrator
