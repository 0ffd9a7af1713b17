// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/queue_config.h"

#include <fmt/format.h>

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr size_t kLongestName = 32;

std::string WithoutCredentials(const std::string& server) {
  const size_t scheme = server.find("://");
  const size_t host = server.rfind('@');
  if (host == std::string::npos) return server;
  return (scheme == std::string::npos ? "" : server.substr(0, scheme + 3)) + server.substr(host + 1);
}

absl::Status CheckAddress(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls) {
  const std::vector<std::string> servers = QueueServers(config);
  if (servers.empty()) {
    return absl::InvalidArgumentError("queue.address: missing; expected servers such as \"nats://127.0.0.1:4222\"");
  }
  for (const std::string& server : servers) {
    const bool encrypted = server.starts_with("tls://");
    if (!encrypted && !server.starts_with("nats://")) {
      return absl::InvalidArgumentError(
          fmt::format("queue.address: \"{}\" is not a server; expected nats://HOST:PORT or tls://HOST:PORT",
                      WithoutCredentials(server).substr(0, 200)));
    }
    if (encrypted && (tls == nullptr || tls->authority_path().empty())) {
      return absl::InvalidArgumentError(
          fmt::format("queue.address: {} is encrypted, and runtime.tls.authority_path does not name the authority that "
                      "signed its certificate",
                      WithoutCredentials(server)));
    }
  }
  return absl::OkStatus();
}

}  // namespace

std::vector<std::string> QueueServers(const config::v1::QueueConfig& config) {
  return absl::StrSplit(config.address(), ',', absl::SkipWhitespace());
}

std::string ShownAddress(const config::v1::QueueConfig& config) {
  std::vector<std::string> servers = QueueServers(config);
  for (std::string& server : servers) server = WithoutCredentials(server);
  return absl::StrJoin(servers, ",");
}

absl::Status CheckQueueConfig(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls) {
  RETURN_IF_ERROR(CheckAddress(config, tls));
  const std::string& name = config.name();
  const bool good_name =
      std::ranges::all_of(name, [](char c) { return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-'; });
  if (!good_name || name.size() > kLongestName) {
    return absl::InvalidArgumentError(
        fmt::format("queue.name: \"{}\" cannot be used; expected at most {} letters, digits and \"-\"",
                    name.substr(0, 80), kLongestName));
  }
  const int replicas = config.replica_count();
  if (replicas != 0 && replicas != 1 && replicas != 3 && replicas != 5) {
    return absl::InvalidArgumentError(fmt::format("queue.replica_count: {} is not one of 1, 3, 5", replicas));
  }
  if (config.has_lease_seconds() && !(config.lease_seconds() >= 1 && config.lease_seconds() <= 3600)) {
    return absl::InvalidArgumentError(
        fmt::format("queue.lease_seconds: {} is out of range [1, 3600]", config.lease_seconds()));
  }
  return absl::OkStatus();
}

namespace {

absl::Status NotHere() {
  return absl::UnimplementedError(
      "queue: this program cannot use NATS servers; flair and flair-orchestrator can (./flair build flair)");
}

NatsForms& Forms() {
  static NatsForms forms{
      [](const auto&, const auto*, const auto&) -> absl::StatusOr<std::unique_ptr<WorkQueue>> { return NotHere(); },
      [](const auto&, const auto*, const auto&) -> absl::StatusOr<std::unique_ptr<ArtifactStore>> {
        return NotHere();
      }};
  return forms;
}

}  // namespace

void UseNats(const NatsForms& forms) { Forms() = forms; }

const NatsForms& Nats() { return Forms(); }

}  // namespace flair::orchestrator
