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
#include <string>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
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
          fmt::format("queue.address: {} is encrypted, and runtime.tls.authority_path does not name the authority that "
                      "signed its certificate",
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

// ---- Why a connection failed

namespace {

// The servers refuse our credentials.
std::string CredentialsFault(const config::v1::QueueConfig& config, const std::string& servers) {
  if (!config.credentials_path().empty()) {
    return fmt::format("queue.credentials_path: {} refuses the credentials in {}", servers, config.credentials_path());
  }
  if (absl::StrContains(config.address(), "@")) {
    return fmt::format("queue.address: {} refuses the user, password or token that the address holds", servers);
  }
  return fmt::format(
      "queue.credentials_path: {} asks for credentials; set it, or address nats://USER:PASSWORD@HOST:PORT or "
      "nats://TOKEN@HOST:PORT",
      servers);
}

// The servers do not take our certificate, or miss one.
std::string CertificateFault(const config::v1::TlsConfig& tls, const std::string& servers) {
  if (tls.certificate_path().empty()) {
    return fmt::format(
        "runtime.tls.certificate_path: {} refuses clients without a certificate; set it, and key_path, to one that its "
        "authority has signed",
        servers);
  }
  return fmt::format(
      "runtime.tls.certificate_path: {} refuses {}; its authority must have signed it, and it must hold today", servers,
      tls.certificate_path());
}

// We do not take theirs; `why` in the words of OpenSSL.
std::string ServerFault(const config::v1::TlsConfig& tls, const std::string& servers, const std::string& why) {
  if (absl::StrContains(why, "mismatch")) {
    return fmt::format(
        "queue.address: the certificate of {} is for another name; call the server as its certificate does "
        "(subjectAltName), or give it one for this name",
        servers);
  }
  if (absl::StrContains(why, "expired") || absl::StrContains(why, "not yet valid")) {
    return fmt::format("queue.address: the certificate of {} does not hold today", servers);
  }
  return fmt::format("runtime.tls.authority_path: {} has not signed the certificate of {}", tls.authority_path(),
                     servers);
}

// What is wrong when authentication failed, on either side; empty otherwise.
std::string TrustFault(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls, natsStatus status,
                       const std::string& why) {
  const std::string servers = ShownAddress(config);
  if (status == NATS_CONNECTION_AUTH_FAILED || status == NATS_NOT_PERMITTED) return CredentialsFault(config, servers);
  if (status == NATS_SECURE_CONNECTION_WANTED) {
    return fmt::format("queue.address: {} is without TLS; give the server a certificate, or say nats://", servers);
  }
  if (tls == nullptr || !absl::StrContains(servers, "tls://")) {
    // cnats tries TLS by itself when a server insists, and knows no authority.
    if (status != NATS_SSL_ERROR && status != NATS_SECURE_CONNECTION_REQUIRED) return "";
    return fmt::format("queue.address: {} takes no plain text; say tls:// and set runtime.tls", servers);
  }
  if (status == NATS_SSL_ERROR) {
    return absl::StrContains(why, "alert") ? CertificateFault(*tls, servers) : ServerFault(*tls, servers, why);
  }
  // With TLS 1.3 a server looks at our certificate when our side is content, and hangs up.
  const bool unreachable = status == NATS_NO_SERVER || status == NATS_TIMEOUT;
  return unreachable ? "" : CertificateFault(*tls, servers);
}

}  // namespace

absl::Status DescribeConnectError(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls, int code) {
  const auto status = static_cast<natsStatus>(code);
  const char* last = nats_GetLastError(nullptr);
  const std::string why = last != nullptr && *last != '\0' ? last : natsStatus_GetText(status);
  const std::string fault = TrustFault(config, tls, status, why);
  if (!fault.empty()) return absl::UnauthenticatedError(fmt::format("{} ({})", fault, why));
  return absl::UnavailableError(
      fmt::format("queue.address: no server answers at {} ({}); start one with JetStream (nats-server --jetstream "
                  "--store_dir FOLDER) or correct the address",
                  ShownAddress(config), why));
}

}  // namespace flair::orchestrator
