// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/connect_error.h"

#include <fmt/format.h>
#include <nats/nats.h>

#include <string>

#include "absl/strings/match.h"
#include "orchestrator/jetstream/connect_options.h"

namespace flair::orchestrator {
namespace {

// The servers do not take what we say of ourselves.
std::string CredentialsFault(const config::v1::QueueConfig& config, const std::string& servers) {
  if (!config.credentials_path().empty()) {
    return fmt::format("queue.credentials_path: {} refuses the credentials in {}", servers, config.credentials_path());
  }
  if (absl::StrContains(config.address(), "@")) {
    return fmt::format("queue.address: {} refuses the user, password or token that the address holds", servers);
  }
  return fmt::format(
      "queue.credentials_path: {} asks who we are; set it, or address nats://USER:PASSWORD@HOST:PORT or "
      "nats://TOKEN@HOST:PORT",
      servers);
}

// The servers do not take our certificate, or miss one.
std::string CertificateFault(const config::v1::TlsConfig& tls, const std::string& servers) {
  if (tls.certificate_path().empty()) {
    return fmt::format(
        "runtime.tls.certificate_path: {} hangs up on who shows no certificate; set it, and key_path, to one that its "
        "authority has signed",
        servers);
  }
  return fmt::format(
      "runtime.tls.certificate_path: {} hangs up on who shows {}; its authority must have signed it, and it must hold "
      "today",
      servers, tls.certificate_path());
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

// What is wrong when it is about who believes whom; empty otherwise.
std::string TrustFault(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls, natsStatus status,
                       const std::string& why) {
  const std::string servers = ShownAddress(config);
  if (status == NATS_CONNECTION_AUTH_FAILED || status == NATS_NOT_PERMITTED) return CredentialsFault(config, servers);
  if (status == NATS_SECURE_CONNECTION_WANTED) {
    return fmt::format("queue.address: {} is without TLS; give the server a certificate, or say nats://", servers);
  }
  if (tls == nullptr || !absl::StrContains(servers, "tls://")) {
    // cnats tries TLS by itself when a server insists, and knows nobody to believe.
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
