// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/connection.h"

#include <fmt/format.h>
#include <nats/nats.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "absl/strings/match.h"
#include "orchestrator/batch/job_rules.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

constexpr int64_t kConnectMs = 2000;
constexpr int64_t kReconnectWaitMs = 200;
// A server that vanished is noticed after two of these.
constexpr int64_t kPingMs = 4000;
// Little is buffered while no server is connected: calls fail instead.
constexpr int kReconnectBufferBytes = 64 * 1024;

struct OptionsDeleter {
  void operator()(natsOptions* options) const { natsOptions_Destroy(options); }
};
using OptionsPtr = std::unique_ptr<natsOptions, OptionsDeleter>;

int64_t Milliseconds(absl::Duration duration) {
  return std::max<int64_t>(1, absl::ToInt64Milliseconds(absl::Ceil(duration, absl::Milliseconds(1))));
}

NatsMessage Read(natsMsg* message) {
  NatsMessage read;
  read.subject = natsMsg_GetSubject(message);
  read.content.assign(natsMsg_GetData(message), static_cast<size_t>(natsMsg_GetDataLength(message)));
  if (const char* reply = natsMsg_GetReply(message)) read.reply = reply;
  const char* status = nullptr;
  if (read.content.empty() && natsMsgHeader_Get(message, "Status", &status) == NATS_OK) read.status = std::atoi(status);
  return read;
}

absl::StatusOr<std::unique_ptr<NatsInbox>> MakeInbox(natsConnection* connection, const std::string& pattern,
                                                     const std::string& subject) {
  natsSubscription* subscription = nullptr;
  const natsStatus status = natsConnection_SubscribeSync(&subscription, connection, pattern.c_str());
  if (status != NATS_OK) {
    return Unavailable("cannot listen to {}: {}", pattern, natsStatus_GetText(status));
  }
  return std::make_unique<NatsInbox>(subscription, subject);
}

absl::Status CheckFile(natsStatus status, const char* field, const std::string& path) {
  if (status == NATS_OK) return absl::OkStatus();
  const char* why = nats_GetLastError(nullptr);
  return InvalidArgument("{}: cannot use {}: {}", field, path, why != nullptr ? why : natsStatus_GetText(status));
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

// INVALID_ARGUMENT when a file of the config cannot be used.
absl::StatusOr<OptionsPtr> MakeOptions(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls) {
  natsOptions* made = nullptr;
  if (natsOptions_Create(&made) != NATS_OK) return absl::ResourceExhaustedError("no memory for a connection");
  OptionsPtr options(made);
  const std::vector<std::string> servers = QueueServers(config);
  std::vector<const char*> urls;
  for (const std::string& server : servers) urls.push_back(server.c_str());
  if (natsOptions_SetServers(made, urls.data(), static_cast<int>(urls.size())) != NATS_OK) {
    return InvalidArgument(
        "queue.address: \"{}\" is not a list of servers; expected nats://HOST:PORT, separated by commas",
        ShownAddress(config).substr(0, 200));
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
  if (encrypted && tls != nullptr) RETURN_IF_ERROR(SetTls(made, *tls));
  if (!config.credentials_path().empty()) {
    // cnats reads it only when it connects, and then does not say why that failed.
    if (::access(config.credentials_path().c_str(), R_OK) != 0) {
      return InvalidArgument("queue.credentials_path: cannot read {}: {}", config.credentials_path(),
                             std::strerror(errno));
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

// The servers reject our certificate, or require one.
std::string CertificateFault(const config::v1::TlsConfig& tls, const std::string& servers) {
  if (tls.certificate_path().empty()) {
    return fmt::format(
        "runtime.tls.certificate_path: {} refuses clients without a certificate; set it, and key_path, to one that its "
        "authority has signed",
        servers);
  }
  return fmt::format(
      "runtime.tls.certificate_path: {} refuses {}; its authority must have signed it, and it must be valid now",
      servers, tls.certificate_path());
}

// We reject the servers' certificate; `why` is OpenSSL's message.
std::string ServerFault(const config::v1::TlsConfig& tls, const std::string& servers, const std::string& why) {
  if (absl::StrContains(why, "mismatch")) {
    return fmt::format(
        "queue.address: the certificate of {} is for another name; call the server as its certificate does "
        "(subjectAltName), or give it one for this name",
        servers);
  }
  if (absl::StrContains(why, "expired") || absl::StrContains(why, "not yet valid")) {
    return fmt::format("queue.address: the certificate of {} has expired or is not valid yet", servers);
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
    return fmt::format("queue.address: {} does not use TLS; give the server a certificate, or use nats://", servers);
  }
  if (tls == nullptr || !absl::StrContains(servers, "tls://")) {
    // cnats switches to TLS by itself when a server requires it, and then has no authority.
    if (status != NATS_SSL_ERROR && status != NATS_SECURE_CONNECTION_REQUIRED) return "";
    return fmt::format("queue.address: {} refuses plain text; use tls:// and set runtime.tls", servers);
  }
  if (status == NATS_SSL_ERROR) {
    return absl::StrContains(why, "alert") ? CertificateFault(*tls, servers) : ServerFault(*tls, servers, why);
  }
  // With TLS 1.3 a server checks our certificate after our side has finished, and then hangs up.
  const bool unreachable = status == NATS_NO_SERVER || status == NATS_TIMEOUT;
  return unreachable ? "" : CertificateFault(*tls, servers);
}

// Why a first connection failed, in a sentence that names the field to look at: UNAUTHENTICATED when one side does not
// accept the other, else UNAVAILABLE. Holds no secret. On the thread that got `status`.
absl::Status DescribeConnectError(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls,
                                  natsStatus status) {
  const char* last = nats_GetLastError(nullptr);
  const std::string why = last != nullptr && *last != '\0' ? last : natsStatus_GetText(status);
  const std::string fault = TrustFault(config, tls, status, why);
  if (!fault.empty()) return absl::UnauthenticatedError(fmt::format("{} ({})", fault, why));
  return Unavailable(
      "queue.address: no server answers at {} ({}); start one with JetStream (nats-server --jetstream "
      "--store_dir FOLDER) or correct the address",
      ShownAddress(config), why);
}

}  // namespace

void NatsMessageDeleter::operator()(natsMsg* message) const { natsMsg_Destroy(message); }

NatsMessagePtr MakeNatsMessage(const NatsRequest& request, const std::string& reply) {
  natsMsg* message = nullptr;
  natsStatus status = natsMsg_Create(&message, request.subject.c_str(), reply.empty() ? nullptr : reply.c_str(),
                                     request.content.data(), static_cast<int>(request.content.size()));
  NatsMessagePtr made(message);
  for (const auto& [name, value] : request.headers) {
    if (status == NATS_OK) status = natsMsgHeader_Set(message, name.c_str(), value.c_str());
  }
  return status == NATS_OK ? std::move(made) : nullptr;
}

NatsInbox::~NatsInbox() { natsSubscription_Destroy(subscription_); }

absl::StatusOr<NatsMessage> NatsInbox::Next(absl::Duration limit) {
  natsMsg* message = nullptr;
  const natsStatus status = natsSubscription_NextMsg(&message, subscription_, Milliseconds(limit));
  const NatsMessagePtr owned(message);
  if (status == NATS_OK) return Read(message);
  // Messages dropped because nobody read them are like messages lost in transit.
  if (status == NATS_TIMEOUT || status == NATS_SLOW_CONSUMER) return absl::DeadlineExceededError("nothing came");
  return absl::CancelledError(natsStatus_GetText(status));
}

void NatsInbox::Close() { natsSubscription_Unsubscribe(subscription_); }

absl::StatusOr<std::unique_ptr<NatsConnection>> NatsConnection::Open(const config::v1::QueueConfig& config,
                                                                     const config::v1::TlsConfig* tls) {
  ASSIGN_OR_RETURN(const OptionsPtr options, MakeOptions(config, tls));
  natsConnection* connection = nullptr;
  const natsStatus status = natsConnection_Connect(&connection, options.get());
  if (status != NATS_OK) return DescribeConnectError(config, tls, status);
  return std::unique_ptr<NatsConnection>(new NatsConnection(connection, ShownAddress(config)));
}

NatsConnection::~NatsConnection() {
  natsConnection_Close(connection_);
  natsConnection_Destroy(connection_);
}

absl::Status NatsConnection::Unreachable(const std::string& why) const {
  // nats-server 2.9 stops for good when its disk is full, and may say nothing or hang up.
  return Unavailable(
      "the queue at {} does not answer ({}); is nats-server running there? If its disk was full, make room and restart "
      "it: work then goes on by itself",
      address_, why);
}

absl::Status NatsConnection::CheckSize(const NatsRequest& request) const {
  const auto size_bytes = static_cast<int64_t>(request.content.size());
  if (size_bytes + 1024 <= max_payload_bytes()) return absl::OkStatus();
  return InvalidArgument(
      "{} bytes are too many for one message of the queue at {}; its servers accept {} (max_payload)", size_bytes,
      address_, max_payload_bytes());
}

absl::StatusOr<NatsMessage> NatsConnection::Request(const NatsRequest& request, absl::Duration limit) {
  RETURN_IF_ERROR(CheckSize(request));
  if (!connected()) return Unreachable("no connection");
  const NatsMessagePtr message = MakeNatsMessage(request, "");
  if (message == nullptr) return absl::ResourceExhaustedError("no memory for a message");
  natsMsg* answer = nullptr;
  const natsStatus status = natsConnection_RequestMsg(&answer, connection_, message.get(), Milliseconds(limit));
  const NatsMessagePtr owned(answer);
  if (status == NATS_OK) return Read(answer);
  if (status == NATS_NO_RESPONDERS) return Unreachable("JetStream is off there, or has no leader at the moment");
  return Unreachable(natsStatus_GetText(status));
}

absl::Status NatsConnection::Publish(const NatsRequest& request, const std::string& reply) {
  RETURN_IF_ERROR(CheckSize(request));
  if (!connected()) return Unreachable("no connection");
  const NatsMessagePtr message = MakeNatsMessage(request, reply);
  if (message == nullptr) return absl::ResourceExhaustedError("no memory for a message");
  const natsStatus status = natsConnection_PublishMsg(connection_, message.get());
  return status == NATS_OK ? absl::OkStatus() : Unreachable(natsStatus_GetText(status));
}

absl::StatusOr<std::unique_ptr<NatsInbox>> NatsConnection::OpenInbox() {
  natsInbox* made = nullptr;
  if (natsInbox_Create(&made) != NATS_OK) return absl::ResourceExhaustedError("no memory for an inbox");
  const std::string subject = made;
  natsInbox_Destroy(made);
  return MakeInbox(connection_, subject + ".*", subject);
}

absl::StatusOr<std::unique_ptr<NatsInbox>> NatsConnection::Subscribe(const std::string& subject) {
  return MakeInbox(connection_, subject, subject);
}

bool NatsConnection::connected() const { return natsConnection_Status(connection_) == NATS_CONN_STATUS_CONNECTED; }

int64_t NatsConnection::reconnect_count() const {
  natsStatistics* statistics = nullptr;
  uint64_t reconnects = 0;
  if (natsStatistics_Create(&statistics) != NATS_OK) return 0;
  if (natsConnection_GetStats(connection_, statistics) == NATS_OK) {
    natsStatistics_GetCounts(statistics, nullptr, nullptr, nullptr, nullptr, &reconnects);
  }
  natsStatistics_Destroy(statistics);
  return static_cast<int64_t>(reconnects);
}

int64_t NatsConnection::max_payload_bytes() const {
  const int64_t bytes = natsConnection_GetMaxPayload(connection_);
  return bytes > 0 ? bytes : int64_t{1} << 20;
}

}  // namespace flair::orchestrator
