// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/stage_channels.h"

#include <fmt/format.h>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::orchestrator {

absl::StatusOr<StageChannels> ConnectStages(const config::v1::OrchestratorConfig& config) {
  StageChannels channels;
  const struct {
    const char* field;
    const std::string& address;
    const char* service;
    StageChannel& channel;
  } stages[] = {
      {"language", config.stages().language(), v1::LanguageService::service_full_name(), channels.language},
      {"translator", config.stages().translator(), v1::TranslatorService::service_full_name(), channels.translator},
      {"optimizer", config.stages().optimizer(), v1::OptimizerService::service_full_name(), channels.optimizer},
      {"renderer", config.stages().renderer(), v1::RendererService::service_full_name(), channels.renderer},
  };
  for (const auto& stage : stages) {
    auto channel = runtime::MakeChannel(stage.address, stage.service, runtime::ChannelOptionsOf(config.runtime()));
    if (!channel.ok()) {
      return absl::InvalidArgumentError(
          fmt::format("stages.{}: {}", stage.field, std::string(channel.status().message())));
    }
    stage.channel = {*std::move(channel), stage.address, fmt::format("stages.{}", stage.field)};
  }
  return channels;
}

}  // namespace flair::orchestrator
