// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/stage_channels.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>

#include <array>
#include <cstring>
#include <set>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr char kDns[] = "dns:///";

// Where a config says that the workers of a stage are.
struct StageSetting {
  const char* name;
  const std::string& addresses;
  const char* service;
  StageChannel StageChannels::*channel;
};

std::array<StageSetting, 4> SettingsOf(const config::v1::OrchestratorConfig& config) {
  const auto& stages = config.stages();
  return {{
      {"stages.language", stages.language(), v1::LanguageService::service_full_name(), &StageChannels::language},
      {"stages.translator", stages.translator(), v1::TranslatorService::service_full_name(),
       &StageChannels::translator},
      {"stages.optimizer", stages.optimizer(), v1::OptimizerService::service_full_name(), &StageChannels::optimizer},
      {"stages.renderer", stages.renderer(), v1::RendererService::service_full_name(), &StageChannels::renderer},
  }};
}

}  // namespace

absl::StatusOr<StageAddresses> ParseStageAddresses(const std::string& text) {
  StageAddresses addresses;
  for (const auto piece : absl::StrSplit(text, ',')) {
    const std::string part(absl::StripAsciiWhitespace(piece));
    const bool unix_socket = part.starts_with("unix:") && part.size() > 5;
    const bool name = part.starts_with(kDns);
    const std::string host_port = name ? part.substr(std::strlen(kDns)) : part;
    const int port = runtime::PortOf(host_port).value_or(0);
    if (!unix_socket && (port == 0 || (!name && part.find('/') != std::string::npos))) {
      return InvalidArgument(
          "address \"{}\": expected HOST:PORT, unix:PATH or dns:///NAME:PORT with a port in [1, 65535], or "
          "several of these, separated by commas",
          part);
    }
    if (name) {
      addresses.names.push_back({host_port.substr(0, host_port.rfind(':')), port});
    } else {
      addresses.workers.push_back(part);
    }
  }
  return addresses;
}

absl::StatusOr<std::vector<std::string>> LookUpHost(const std::string& host) {
  addrinfo hints = {};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = AI_ADDRCONFIG;
  addrinfo* found = nullptr;
  const int error = getaddrinfo(host.c_str(), nullptr, &hints, &found);
  if (error != 0) return Unavailable("the name {} cannot be resolved: {}", host, gai_strerror(error));
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(found, freeaddrinfo);
  std::set<std::string> addresses;
  for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
    char text[INET6_ADDRSTRLEN] = {};
    const void* address = entry->ai_family == AF_INET6
                              ? static_cast<void*>(&reinterpret_cast<sockaddr_in6*>(entry->ai_addr)->sin6_addr)
                              : static_cast<void*>(&reinterpret_cast<sockaddr_in*>(entry->ai_addr)->sin_addr);
    if (inet_ntop(entry->ai_family, address, text, sizeof(text)) != nullptr) addresses.insert(text);
  }
  return std::vector<std::string>(addresses.begin(), addresses.end());
}

std::string JoinHostPort(const std::string& host, int port) {
  return host.find(':') == std::string::npos ? fmt::format("{}:{}", host, port) : fmt::format("[{}]:{}", host, port);
}

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
  for (const StageSetting& stage : SettingsOf(config)) {
    absl::StatusOr<StageAddresses> addresses = ParseStageAddresses(stage.addresses);
    const ConnectWorker connect = ConnectorTo(stage.service, runtime::ChannelOptionsOf(config.runtime()));
    // What can be known now of a channel that cannot be made is said now.
    absl::Status status = addresses.status();
    for (size_t i = 0; status.ok() && i < addresses->workers.size(); ++i) {
      status = connect(addresses->workers[i], "").status();
    }
    if (!status.ok()) {
      return InvalidArgument("{}: {}", stage.name, status.message());
    }
    channels.*stage.channel = {nullptr, stage.addresses, stage.name, connect};
  }
  return channels;
}

void CheckStageConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  for (const StageSetting& stage : SettingsOf(config)) {
    if (stage.addresses.empty()) {
      checker.Report(stage.name,
                     "missing; expected HOST:PORT, unix:PATH or dns:///NAME:PORT, or several, separated by commas");
    } else if (const absl::Status status = ParseStageAddresses(stage.addresses).status(); !status.ok()) {
      checker.Report(stage.name, std::string(status.message()));
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
