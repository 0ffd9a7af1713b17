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

// Jobs that are handed out in the order in which they came, by one durable consumer of the queue stream: the alone
// standing ones, those of a batch, or one that was asked for by name.
struct Lane {
  // The consumer: "single", "batch-ID", "named-ID".
  std::string consumer;
  // What it hands out, with wildcards.
  std::string filter;
  // Of a batch's.
  std::string batch_id;
};

// A job that a consumer handed out to this process alone, until it is not told of progress for the time of a lease.
struct Handed {
  std::string job_id;
  // Where acknowledgements go.
  std::string acknowledge;
  // Its message.
  uint64_t sequence = 0;
  int64_t delivery_count = 0;
};

// Which lanes there are, and what is next in each. Knows of lanes by Want and See, asks only those that may have
// something. Thread-safe.
class Lanes {
 public:
  explicit Lanes(QueueParts& parts) : parts_(parts) {}

  // The lane of a subject of the queue stream.
  Lane LaneOf(const std::string& subject) const;

  // There may be something under this subject; in all known lanes.
  void Want(const std::string& subject);
  void WantAll();
  // Forgets that it asked the batch's lane.
  void WantBatch(const std::string& batch_id);

  // Messages by subject, as the stream counts them: who waits or runs.
  absl::StatusOr<std::map<std::string, int64_t>> Look(const std::string& filter);
  // Wants all lanes of those and returns the ones that are no more. `any`: there are some.
  std::vector<Lane> See(const std::map<std::string, int64_t>& messages_by_subject);

  // Lanes that may have something, in the order in which to ask: alone standing jobs, then the batches in turn.
  std::vector<Lane> Candidates(const TakeFilter& filter);

  // The next of a lane; nothing when it has none now.
  absl::StatusOr<std::optional<Handed>> Next(const Lane& lane);
  // The batch had its turn.
  void HadTurn(const Lane& lane);

  // Ends the lane: its consumer goes, and its messages up to that sequence, whose jobs have ended. A job that is
  // retried just now has a later one, and whoever asks for it makes the consumer again.
  absl::Status Remove(const Lane& lane, uint64_t ended_sequence);

  // Messages of lanes that nobody has (waiting) and that somebody has (running, or waiting for another run).
  struct Depth {
    int64_t waiting = 0;
    int64_t handed = 0;
  };
  absl::StatusOr<Depth> DepthOf(const std::map<std::string, int64_t>& messages_by_subject);

 private:
  struct State {
    Lane lane;
    // Counts reasons to ask; asked when it differs from what it was at the last vain question.
    int64_t wanted = 1;
    int64_t asked = 0;
    // This process made sure that the consumer is there.
    bool has_consumer = false;
  };
  absl::Status MakeConsumer(const Lane& lane);
  absl::StatusOr<std::optional<Handed>> Ask(const Lane& lane);

  QueueParts& parts_;
  std::mutex mutex_;
  // By consumer.
  std::map<std::string, State> lanes_;
  std::string last_turn_;
};

}  // namespace flair::orchestrator
