// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/connection.h"

typedef struct __jsCtx jsCtx;

namespace flair::orchestrator {

class PendingMessages;

// A message as a stream keeps it.
struct StoredMessage {
  std::string subject;
  std::string content;
  uint64_t sequence = 0;
};

// Headers of a message to be stored: once for one id, for some minutes; only if the last message of its subject has
// that sequence, 0 for none (ABORTED otherwise).
NatsRequest WithMessageId(std::string subject, std::string content, const std::string& message_id);
NatsRequest WithExpected(std::string subject, std::string content, uint64_t expected);

// How a stream is made.
struct StreamOptions {
  std::string name;
  std::string subject;
  int replica_count = 1;
  // A message goes when it has been acknowledged.
  bool work_queue = false;
  // Only the latest message of a subject is kept.
  bool latest_only = false;
  // Kept in memory, for so long; on disk for ever when infinite.
  absl::Duration life = absl::InfiniteDuration();
};

// Streams of JetStream and their consumers, through cnats. Calls block; those for many keys use a few threads. A call
// is repeated while the answer is UNAVAILABLE, up to a limit, so a caller must make sure that a second time does no
// harm. Thread-safe.
//   UNAVAILABLE         no answer; no leader just now
//   RESOURCE_EXHAUSTED  the servers have no room
//   NOT_FOUND           no such stream, consumer or message
//   ABORTED             the last message of the subject is not the expected one
class Streams {
 public:
  // `connection` outlives it. `limit`: how long calls are repeated.
  Streams(NatsConnection& connection, absl::Duration limit);
  ~Streams();

  // Makes the stream unless it is there.
  absl::Status Make(const StreamOptions& options);

  // Stores a message and returns its sequence. To be repeated safely, it has an id or an expected sequence.
  absl::StatusOr<uint64_t> Publish(const NatsRequest& message);
  // Without repetition.
  absl::StatusOr<uint64_t> PublishOnce(const NatsRequest& message);
  // Stored in their order, unless the servers had to be asked again for some.
  std::vector<absl::StatusOr<uint64_t>> PublishAll(std::span<const NatsRequest> messages);
  // The same; the first error.
  absl::Status PublishEach(std::span<const NatsRequest> messages);

  // Read from the stream's leader, so that a write is seen by all later reads.
  absl::StatusOr<StoredMessage> Get(const std::string& stream, uint64_t sequence);
  absl::StatusOr<StoredMessage> Last(const std::string& stream, const std::string& subject);
  // Without repetition.
  absl::StatusOr<StoredMessage> LastOnce(const std::string& stream, const std::string& subject, absl::Duration limit);
  std::vector<absl::StatusOr<StoredMessage>> LastOfEach(const std::string& stream,
                                                        std::span<const std::string> subjects);
  // At most `limit` messages of the filter from a sequence on, in order.
  absl::StatusOr<std::vector<StoredMessage>> Read(const std::string& stream, const std::string& filter,
                                                  uint64_t first_sequence, int limit);

  // Removes messages. False for those that are not there.
  std::vector<absl::StatusOr<bool>> Remove(const std::string& stream, std::span<const uint64_t> sequences);
  // Removes the messages of the filter before a sequence; all when it is 0.
  absl::Status Purge(const std::string& stream, const std::string& filter, uint64_t end_sequence = 0);

  // The highest sequence that the stream gave; 0 when none.
  absl::StatusOr<uint64_t> LastSequence(const std::string& stream);
  // Messages by subject.
  absl::StatusOr<std::map<std::string, int64_t>> Subjects(const std::string& stream, const std::string& filter);
  // How many messages match the filter, counted by the servers.
  absl::StatusOr<int64_t> Count(const std::string& stream, const std::string& filter);

  // A durable consumer whose messages must be acknowledged, or reported to be in progress, within `ack_wait`.
  absl::Status MakeConsumer(const std::string& stream, const std::string& consumer, const std::string& filter,
                            absl::Duration ack_wait);
  absl::Status RemoveConsumer(const std::string& stream, const std::string& consumer);
  // Messages of a consumer that nobody has had, and that were delivered and not acknowledged.
  struct Depth {
    int64_t waiting = 0;
    int64_t delivered = 0;
  };
  std::vector<absl::StatusOr<Depth>> DepthOfEach(const std::string& stream, std::span<const std::string> consumers);

  NatsConnection& connection() { return connection_; }

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
  template <typename T, typename Call>
  std::vector<absl::StatusOr<T>> ForEach(size_t count, const Call& call);
  // `call(jsOptions*, jsErrCode*)` returns a natsStatus.
  template <typename Call>
  absl::Status Once(const Call& call);
  template <typename Call>
  absl::Status Repeated(const Call& call);
  // The text is cnats's last error when there is none.
  absl::Status ToStatus(int nats_status, int error_code, const char* text = nullptr) const;
  absl::StatusOr<StoredMessage> Next(const std::string& stream, const std::string& filter, uint64_t sequence);

  NatsConnection& connection_;
  const absl::Duration limit_;
  jsCtx* context_ = nullptr;
  // Publishes without waiting for each answer; `pending_` awaits the answers.
  std::unique_ptr<PendingMessages> pending_;
  jsCtx* publishing_ = nullptr;
};

}  // namespace flair::orchestrator
