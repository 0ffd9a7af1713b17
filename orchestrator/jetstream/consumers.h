// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// One durable consumer of the queue stream, which delivers jobs in the order in which they came: those without a batch,
// those of one batch, or one job that was asked for by its id.
struct Consumer {
  // "single", "batch-ID", "named-ID".
  std::string name;
  // What it delivers, with wildcards.
  std::string filter;
  // Of a batch's.
  std::string batch_id;
};

// A job that a consumer delivered to this process alone, until it is not told of progress for the time of a lease.
struct Delivery {
  std::string job_id;
  // Where acknowledgements go.
  std::string acknowledge;
  // Its message.
  uint64_t sequence = 0;
  int64_t delivery_count = 0;
};

// Which consumers there are, and what is next in each. Knows of them by Want and See, asks only those that may have
// something. Thread-safe.
class Consumers {
 public:
  explicit Consumers(QueueParts& parts) : parts_(parts) {}

  // The consumer of a subject of the queue stream.
  Consumer ConsumerOf(const std::string& subject) const;

  // There may be something under this subject.
  void Want(const std::string& subject);
  // Forgets that it asked the batch's consumer.
  void WantBatch(const std::string& batch_id);

  // Messages by subject, as the stream counts them: who waits or runs.
  absl::StatusOr<std::map<std::string, int64_t>> Look(const std::string& filter);
  // Wants all consumers of those and returns the ones that have no messages any more.
  std::vector<Consumer> See(const std::map<std::string, int64_t>& messages_by_subject);

  // Consumers that may have something, in the order in which to ask: jobs without a batch, then the batches in turn.
  std::vector<Consumer> Candidates(const TakeFilter& filter);

  // The next of a consumer; nothing when it has none now.
  absl::StatusOr<std::optional<Delivery>> Next(const Consumer& consumer);
  // The batch had its turn.
  void HadTurn(const Consumer& consumer);

  // Ends the consumer: its consumer goes, and its messages up to that sequence, whose jobs have ended. A job that is
  // retried just now has a later one, and whoever asks for it makes the consumer again.
  absl::Status Remove(const Consumer& consumer, uint64_t ended_sequence);

  // Messages of consumers that nobody has (waiting) and that somebody has (running, or waiting for another run).
  struct Depth {
    int64_t waiting = 0;
    int64_t delivered = 0;
  };
  absl::StatusOr<Depth> DepthOf(const std::map<std::string, int64_t>& messages_by_subject);

 private:
  struct State {
    Consumer consumer;
    // Counts reasons to ask; asked when it differs from what it was at the last vain question.
    int64_t wanted = 1;
    int64_t asked = 0;
    // This process made sure that the consumer is there.
    bool has_consumer = false;
  };
  absl::Status MakeConsumer(const Consumer& consumer);
  absl::StatusOr<std::optional<Delivery>> Ask(const Consumer& consumer);

  QueueParts& parts_;
  std::mutex mutex_;
  // By consumer.
  std::map<std::string, State> consumers_;
  std::string last_turn_;
};

}  // namespace flair::orchestrator
