// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/config/v1/runtime_config.pb.h"

typedef struct __natsConnection natsConnection;
typedef struct __natsMsg natsMsg;
typedef struct __natsSubscription natsSubscription;

namespace flair::orchestrator {

// A message to a server.
struct NatsRequest {
  std::string subject;
  std::string content;
  std::vector<std::pair<std::string, std::string>> headers;
};

struct NatsMessageDeleter {
  void operator()(natsMsg* message) const;
};
using NatsMessagePtr = std::unique_ptr<natsMsg, NatsMessageDeleter>;
// The message as cnats has it; null without memory.
NatsMessagePtr MakeNatsMessage(const NatsRequest& request, const std::string& reply = "");

// A message from a server.
struct NatsMessage {
  std::string subject;
  std::string content;
  // Where an answer to it, such as an acknowledgement, goes.
  std::string reply;
  // The server's own, without content: 404 no message, 408 too late, 409 consumer gone, 503 nobody there; 0 for others.
  int status = 0;
};

// A subscription to a subject, read by one thread.
class NatsInbox {
 public:
  NatsInbox(natsSubscription* subscription, std::string subject)
      : subscription_(subscription), subject_(std::move(subject)) {}
  ~NatsInbox();
  NatsInbox(const NatsInbox&) = delete;
  NatsInbox& operator=(const NatsInbox&) = delete;

  // Without wildcards: answers go to subject() + "." + anything.
  const std::string& subject() const { return subject_; }
  // DEADLINE_EXCEEDED when nothing came, CANCELLED after Close.
  absl::StatusOr<NatsMessage> Next(absl::Duration limit);
  // Ends a waiting Next and all later ones.
  void Close();

 private:
  natsSubscription* const subscription_;
  const std::string subject_;
};

// One connection to NATS servers, which reconnects for ever. Thread-safe.
class NatsConnection {
 public:
  // Errors as OpenJetStreamQueue, but for those that concern JetStream.
  static absl::StatusOr<std::unique_ptr<NatsConnection>> Open(const config::v1::QueueConfig& config,
                                                              const config::v1::TlsConfig* tls);
  ~NatsConnection();
  NatsConnection(const NatsConnection&) = delete;
  NatsConnection& operator=(const NatsConnection&) = delete;

  // Sends and waits for the answer, which must come under the subject that it is sent to, as those of JetStream's API
  // do; jobs that a consumer delivers do not (Consumers::Ask). UNAVAILABLE without one within `limit`, at once when
  // there is no connection; INVALID_ARGUMENT when the servers take no message of that size.
  absl::StatusOr<NatsMessage> Request(const NatsRequest& request, absl::Duration limit);

  // Sends without waiting. With `reply`, an answer goes there.
  absl::Status Publish(const NatsRequest& request, const std::string& reply = "");

  // An inbox: a new subject and the subscription to it.
  absl::StatusOr<std::unique_ptr<NatsInbox>> OpenInbox();
  // Subscribes to `subject`, which may have wildcards.
  absl::StatusOr<std::unique_ptr<NatsInbox>> Subscribe(const std::string& subject);

  bool connected() const;
  // Grows with each reconnection.
  int64_t reconnect_count() const;
  // Largest message that the servers take.
  int64_t max_payload_bytes() const;
  // INVALID_ARGUMENT when the servers take no message of that size.
  absl::Status CheckSize(const NatsRequest& request) const;
  // UNAVAILABLE, with a message for the operator of the servers.
  absl::Status Unreachable(const std::string& why) const;
  // The addresses for messages, without secrets.
  const std::string& address() const { return address_; }
  natsConnection* handle() const { return connection_; }

 private:
  NatsConnection(natsConnection* connection, std::string address)
      : connection_(connection), address_(std::move(address)) {}

  natsConnection* const connection_;
  const std::string address_;
};

}  // namespace flair::orchestrator
