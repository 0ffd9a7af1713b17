// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/connection.h"

#include <fmt/format.h>
#include <nats/nats.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "orchestrator/jetstream/connect_options.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Requests of RequestAll on their way at once: enough to hide the way, few enough for the buffers between.
constexpr size_t kRequestsAtOnce = 500;
// How long RequestAll goes without looking whether the connection still is.
constexpr absl::Duration kGlance = absl::Milliseconds(250);

struct MessageDeleter {
  void operator()(natsMsg* message) const { natsMsg_Destroy(message); }
};
using MessagePtr = std::unique_ptr<natsMsg, MessageDeleter>;

int64_t Milliseconds(absl::Duration duration) {
  return std::max<int64_t>(1, absl::ToInt64Milliseconds(absl::Ceil(duration, absl::Milliseconds(1))));
}

MessagePtr MakeMessage(const NatsRequest& request, const std::string& reply) {
  natsMsg* message = nullptr;
  natsStatus status = natsMsg_Create(&message, request.subject.c_str(), reply.empty() ? nullptr : reply.c_str(),
                                     request.content.data(), static_cast<int>(request.content.size()));
  MessagePtr made(message);
  for (const auto& [name, value] : request.headers) {
    if (status == NATS_OK) status = natsMsgHeader_Set(message, name.c_str(), value.c_str());
  }
  return status == NATS_OK ? std::move(made) : nullptr;
}

NatsMessage Read(natsMsg* message) {
  NatsMessage read;
  read.subject = natsMsg_GetSubject(message);
  read.content.assign(natsMsg_GetData(message), static_cast<size_t>(natsMsg_GetDataLength(message)));
  if (const char* reply = natsMsg_GetReply(message)) read.reply = reply;
  const char* status = nullptr;
  if (read.content.empty() && natsMsgHeader_Get(message, "Status", &status) == NATS_OK) {
    read.status = std::atoi(status);
  }
  return read;
}

// The last token of "_INBOX.abc.17" as a number; -1 when it is none.
int NumberOf(const std::string& subject) {
  const size_t dot = subject.rfind('.');
  if (dot == std::string::npos || dot + 1 == subject.size()) return -1;
  return std::atoi(subject.c_str() + dot + 1);
}

absl::StatusOr<std::unique_ptr<NatsInbox>> MakeInbox(natsConnection* connection, const std::string& pattern,
                                                     const std::string& subject) {
  natsSubscription* subscription = nullptr;
  const natsStatus status = natsConnection_SubscribeSync(&subscription, connection, pattern.c_str());
  if (status != NATS_OK) {
    return absl::UnavailableError(fmt::format("cannot listen to {}: {}", pattern, natsStatus_GetText(status)));
  }
  return std::make_unique<NatsInbox>(subscription, subject);
}

}  // namespace

NatsInbox::~NatsInbox() { natsSubscription_Destroy(subscription_); }

absl::StatusOr<NatsMessage> NatsInbox::Next(absl::Duration limit) {
  natsMsg* message = nullptr;
  const natsStatus status = natsSubscription_NextMsg(&message, subscription_, Milliseconds(limit));
  const MessagePtr owned(message);
  if (status == NATS_OK) return Read(message);
  // Messages that were dropped because nobody read them are like messages lost on the way.
  if (status == NATS_TIMEOUT || status == NATS_SLOW_CONSUMER) return absl::DeadlineExceededError("nothing came");
  return absl::CancelledError(natsStatus_GetText(status));
}

void NatsInbox::Close() { natsSubscription_Unsubscribe(subscription_); }

absl::StatusOr<std::unique_ptr<NatsConnection>> NatsConnection::Open(const config::v1::QueueConfig& config,
                                                                     const config::v1::TlsConfig* tls) {
  ASSIGN_OR_RETURN(NatsOptionsPtr options, MakeConnectOptions(config, tls));
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
  return absl::UnavailableError(fmt::format(
      "the queue at {} does not answer ({}); is nats-server running there, and may it be reached?", address_, why));
}

absl::Status NatsConnection::CheckSize(const NatsRequest& request) const {
  const auto size_bytes = static_cast<int64_t>(request.content.size());
  if (size_bytes + 1024 <= max_payload_bytes()) return absl::OkStatus();
  return absl::InvalidArgumentError(
      fmt::format("{} bytes are too much for one message of the queue at {}; its servers take {} (max_payload)",
                  size_bytes, address_, max_payload_bytes()));
}

absl::StatusOr<NatsMessage> NatsConnection::Request(const NatsRequest& request, absl::Duration limit) {
  RETURN_IF_ERROR(CheckSize(request));
  if (!connected()) return Unreachable("no connection");
  const MessagePtr message = MakeMessage(request, "");
  if (message == nullptr) return absl::ResourceExhaustedError("no memory for a message");
  natsMsg* answer = nullptr;
  const natsStatus status = natsConnection_RequestMsg(&answer, connection_, message.get(), Milliseconds(limit));
  const MessagePtr owned(answer);
  if (status == NATS_OK) return Read(answer);
  if (status == NATS_NO_RESPONDERS) return Unreachable("JetStream is off there, or has no leader just now");
  return Unreachable(natsStatus_GetText(status));
}

absl::Status NatsConnection::Publish(const NatsRequest& request, const std::string& reply) {
  RETURN_IF_ERROR(CheckSize(request));
  if (!connected()) return Unreachable("no connection");
  const MessagePtr message = MakeMessage(request, reply);
  if (message == nullptr) return absl::ResourceExhaustedError("no memory for a message");
  const natsStatus status = natsConnection_PublishMsg(connection_, message.get());
  return status == NATS_OK ? absl::OkStatus() : Unreachable(natsStatus_GetText(status));
}

std::vector<absl::StatusOr<NatsMessage>> NatsConnection::RequestAll(std::span<const NatsRequest> requests,
                                                                    absl::Duration limit) {
  std::vector<absl::StatusOr<NatsMessage>> answers(requests.size(), Unreachable("no answer in time"));
  auto inbox = OpenInbox();
  if (!inbox.ok()) return std::vector<absl::StatusOr<NatsMessage>>(requests.size(), inbox.status());
  const absl::Time deadline = absl::Now() + limit;
  size_t sent = 0;
  size_t waiting = 0;
  while (sent < requests.size() || waiting > 0) {
    while (sent < requests.size() && waiting < kRequestsAtOnce) {
      const absl::Status status = Publish(requests[sent], fmt::format("{}.{}", (*inbox)->subject(), sent));
      if (status.ok()) ++waiting;
      if (!status.ok()) answers[sent] = status;
      ++sent;
    }
    if (waiting == 0) continue;
    const absl::Duration left = deadline - absl::Now();
    if (left <= absl::ZeroDuration() || !connected()) break;
    absl::StatusOr<NatsMessage> answer = (*inbox)->Next(std::min(left, kGlance));
    if (absl::IsDeadlineExceeded(answer.status())) continue;
    if (!answer.ok()) break;
    const int number = NumberOf(answer->subject);
    if (number < 0 || static_cast<size_t>(number) >= requests.size()) continue;
    --waiting;
    if (answer->status == 503) {
      answers[static_cast<size_t>(number)] = Unreachable("JetStream is off there, or has no leader just now");
    } else {
      answers[static_cast<size_t>(number)] = std::move(answer);
    }
  }
  return answers;
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
