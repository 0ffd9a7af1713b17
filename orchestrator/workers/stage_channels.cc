// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_channels.h"

#include <fmt/format.h>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "orchestrator/workers/addresses.h"

namespace flair::orchestrator {

ConnectWorker ConnectorTo(const std::string& service, const runtime::ChannelOptions& options) {
  return [service, options](const std::string& address, const std::string& server_name) {
    runtime::ChannelOptions of_worker = options;
    of_worker.server_name = server_name;
    of_worker.only_while_serving = true;
    return runtime::MakeChannel(address, service, of_worker);
  };
}

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
    const std::string setting = fmt::format("stages.{}", stage.field);
    absl::StatusOr<StageAddresses> addresses = ParseStageAddresses(stage.address);
    const ConnectWorker connect = ConnectorTo(stage.service, runtime::ChannelOptionsOf(config.runtime()));
    // What can be known now of a channel that cannot be made is said now.
    absl::Status status = addresses.status();
    for (size_t i = 0; status.ok() && i < addresses->workers.size(); ++i) {
      status = connect(addresses->workers[i], "").status();
    }
    if (!status.ok()) return absl::InvalidArgumentError(fmt::format("{}: {}", setting, std::string(status.message())));
    stage.channel = {nullptr, stage.address, setting, connect};
  }
  return channels;
}

void CheckStageConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  const std::pair<const char*, const std::string&> stages[] = {{"stages.language", config.stages().language()},
                                                               {"stages.translator", config.stages().translator()},
                                                               {"stages.optimizer", config.stages().optimizer()},
                                                               {"stages.renderer", config.stages().renderer()}};
  for (const auto& [path, addresses] : stages) {
    if (addresses.empty()) {
      checker.Report(path,
                     "missing; expected HOST:PORT, unix:PATH or dns:///NAME:PORT, or several with commas between");
    } else if (const absl::Status status = ParseStageAddresses(addresses).status(); !status.ok()) {
      checker.Report(path, std::string(status.message()));
    }
  }
  const config::v1::StageCallConfig& calls = config.stage_calls();
  checker.Range("stage_calls.in_flight_limit", calls.in_flight_limit(), 0, 1024);
  checker.Range("stage_calls.failure_limit", calls.failure_limit(), 0, 100);
  if (calls.has_recovery_seconds())
    checker.Range("stage_calls.recovery_seconds", calls.recovery_seconds(), 0.001, 3600);
  if (calls.has_hedge_seconds()) checker.Range("stage_calls.hedge_seconds", calls.hedge_seconds(), 0.001, 3600);
}

}  // namespace flair::orchestrator
