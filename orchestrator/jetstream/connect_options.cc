// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/connect_options.h"

#include <fmt/format.h>
#include <nats/nats.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr int64_t kConnectMs = 2000;
constexpr int64_t kReconnectWaitMs = 200;
// A server that is gone without saying so is noticed after two of these.
constexpr int64_t kPingMs = 4000;
constexpr size_t kLongestName = 32;
// Little is kept for a server that is away: calls say that it is.
constexpr int kReconnectBufferBytes = 64 * 1024;

std::vector<std::string> Servers(const config::v1::QueueConfig& config) {
  return absl::StrSplit(config.address(), ',', absl::SkipWhitespace());
}

std::string WithoutCredentials(const std::string& server) {
  const size_t scheme = server.find("://");
  const size_t host = server.rfind('@');
  if (host == std::string::npos) return server;
  return (scheme == std::string::npos ? "" : server.substr(0, scheme + 3)) + server.substr(host + 1);
}

absl::Status CheckAddress(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls) {
  const std::vector<std::string> servers = Servers(config);
  if (servers.empty()) {
    return absl::InvalidArgumentError("queue.address: missing; expected servers such as \"nats://127.0.0.1:4222\"");
  }
  for (const std::string& server : servers) {
    const bool encrypted = server.starts_with("tls://");
    if (!encrypted && !server.starts_with("nats://")) {
      return absl::InvalidArgumentError(
          fmt::format("queue.address: \"{}\" is no server; expected nats://HOST:PORT or tls://HOST:PORT",
                      WithoutCredentials(server).substr(0, 200)));
    }
    if (encrypted && (tls == nullptr || tls->authority_path().empty())) {
      return absl::InvalidArgumentError(
          fmt::format("queue.address: {} is encrypted, and runtime.tls.authority_path does not say whom to believe",
                      WithoutCredentials(server)));
    }
  }
  return absl::OkStatus();
}

absl::Status CheckFile(natsStatus status, const char* field, const std::string& path) {
  if (status == NATS_OK) return absl::OkStatus();
  const char* why = nats_GetLastError(nullptr);
  return absl::InvalidArgumentError(
      fmt::format("{}: cannot use {}: {}", field, path, why != nullptr ? why : natsStatus_GetText(status)));
}

absl::Status SetTls(natsOptions* options, const config::v1::TlsConfig& tls) {
  natsOptions_SetSecure(options, true);
  absl::Status status = CheckFile(natsOptions_LoadCATrustedCertificates(options, tls.authority_path().c_str()),
                                  "runtime.tls.authority_path", tls.authority_path());
  if (status.ok() && !tls.certificate_path().empty()) {
    status =
        CheckFile(natsOptions_LoadCertificatesChain(options, tls.certificate_path().c_str(), tls.key_path().c_str()),
                  "runtime.tls.certificate_path", tls.certificate_path());
  }
  return status;
}

}  // namespace

void NatsOptionsDeleter::operator()(natsOptions* options) const { natsOptions_Destroy(options); }

std::string ShownAddress(const config::v1::QueueConfig& config) {
  std::vector<std::string> servers = Servers(config);
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

absl::StatusOr<NatsOptionsPtr> MakeConnectOptions(const config::v1::QueueConfig& config,
                                                  const config::v1::TlsConfig* tls) {
  natsOptions* made = nullptr;
  if (natsOptions_Create(&made) != NATS_OK) return absl::ResourceExhaustedError("no memory for a connection");
  NatsOptionsPtr options(made);
  const std::vector<std::string> servers = Servers(config);
  std::vector<const char*> urls;
  for (const std::string& server : servers) urls.push_back(server.c_str());
  if (natsOptions_SetServers(made, urls.data(), static_cast<int>(urls.size())) != NATS_OK) {
    return absl::InvalidArgumentError(
        fmt::format("queue.address: \"{}\" is no list of servers; expected nats://HOST:PORT, with commas between",
                    ShownAddress(config).substr(0, 200)));
  }
  natsOptions_SetName(made, "flair");
  natsOptions_SetTimeout(made, kConnectMs);
  natsOptions_SetMaxReconnect(made, std::numeric_limits<int>::max());
  natsOptions_SetReconnectWait(made, kReconnectWaitMs);
  natsOptions_SetPingInterval(made, kPingMs);
  natsOptions_SetMaxPingsOut(made, 1);
  natsOptions_SetReconnectBufSize(made, kReconnectBufferBytes);
  natsOptions_SetFailRequestsOnDisconnect(made, true);
  const bool encrypted = std::ranges::any_of(servers, [](const std::string& s) { return s.starts_with("tls://"); });
  if (encrypted && tls != nullptr) {
    RETURN_IF_ERROR(SetTls(made, *tls));
  }
  if (!config.credentials_path().empty()) {
    // cnats reads it when it connects, and then says no more than that it could not.
    if (::access(config.credentials_path().c_str(), R_OK) != 0) {
      return absl::InvalidArgumentError(
          fmt::format("queue.credentials_path: cannot read {}: {}", config.credentials_path(), std::strerror(errno)));
    }
    if (absl::Status status =
            CheckFile(natsOptions_SetUserCredentialsFromFiles(made, config.credentials_path().c_str(), nullptr),
                      "queue.credentials_path", config.credentials_path());
        !status.ok()) {
      return status;
    }
  }
  return options;
}

}  // namespace flair::orchestrator
