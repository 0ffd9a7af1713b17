// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "orchestrator/jetstream/connection.h"

namespace flair::orchestrator {

// What a stream says of a message that it took.
struct StoredAck {
  uint64_t sequence = 0;
  // It has one of the same Nats-Msg-Id already.
  bool duplicate = false;
};

// What JetStream is asked, on the subjects and in the JSON of its protocol ("$JS.API.>", NATS ADR-1 and following).
// Everything is asked again while the answer is UNAVAILABLE, for as long as the calls' limit; who asks for something
// that must not be done twice makes it so that a second time changes nothing. Thread-safe.
//   UNAVAILABLE         no answer; no leader just now
//   RESOURCE_EXHAUSTED  the servers have no room
//   NOT_FOUND           no such stream, consumer or message
//   ABORTED             a stream's last message of the subject is not the one that was expected
class JetStreamApi {
 public:
  JetStreamApi(NatsConnection& connection, absl::Duration limit) : connection_(connection), limit_(limit) {}

  // `verb`: such as "STREAM.INFO.flair-queue".
  absl::StatusOr<nlohmann::json> Call(const std::string& verb, const nlohmann::json& request);
  // Independent of each other, at once; not asked again.
  std::vector<absl::StatusOr<nlohmann::json>> CallAll(
      std::span<const std::pair<std::string, nlohmann::json>> verbs_and_requests);

  // Stores a message. Again only where that changes nothing: with a Nats-Msg-Id or what it expects.
  absl::StatusOr<StoredAck> Publish(const NatsRequest& message);
  // Not again; see WhileUnavailable.
  absl::StatusOr<StoredAck> PublishOnce(const NatsRequest& message);
  // Those that were not answered are published again; see Publish.
  std::vector<absl::StatusOr<StoredAck>> PublishAll(std::span<const NatsRequest> messages);
  // The same; the first error of all, in their order.
  absl::Status PublishEach(std::span<const NatsRequest> messages);

  // Waits for the answer to one request on any subject.
  absl::StatusOr<NatsMessage> Request(const NatsRequest& request);

  // What an answer says, for those who asked on the connection itself.
  absl::StatusOr<nlohmann::json> Parse(const absl::StatusOr<NatsMessage>& answer) const;

  NatsConnection& connection() { return connection_; }
  absl::Duration limit() const { return limit_; }

  // Repeats `ask` while it says UNAVAILABLE and `more` allows.
  template <typename Ask, typename More>
  static auto WhileUnavailable(Ask ask, More more) {
    absl::Duration wait = absl::Milliseconds(20);
    while (true) {
      auto answer = ask();
      if (!absl::IsUnavailable(StatusOf(answer)) || !more()) return answer;
      std::this_thread::sleep_for(absl::ToChronoMilliseconds(wait));
      wait = std::min(2 * wait, absl::Milliseconds(500));
    }
  }
  template <typename Ask>
  auto WithinLimit(Ask ask) {
    const absl::Time deadline = absl::Now() + limit_;
    return WhileUnavailable(ask, [deadline] { return absl::Now() < deadline; });
  }

 private:
  static const absl::Status& StatusOf(const absl::Status& status) { return status; }
  template <typename T>
  static const absl::Status& StatusOf(const absl::StatusOr<T>& result) {
    return result.status();
  }
  absl::StatusOr<StoredAck> ParseAck(const absl::StatusOr<NatsMessage>& answer) const;

  NatsConnection& connection_;
  const absl::Duration limit_;
};

}  // namespace flair::orchestrator
