// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::orchestrator {

// The hold of one run on its job.
struct Hold {
  std::string job_id;
  // As in JobRecord.holder: unique per run.
  std::string holder;
  // Where the message of the queue stream wants its acknowledgements.
  std::string acknowledge;
  runtime::Cancellation cancellation;
  std::atomic<bool> cancel_requested = false;
  std::atomic<bool> lost = false;
  // The run itself gives the job away or ends it: a record without its name is no loss then.
  std::atomic<bool> closing = false;

  // Another run may have the job: tells the run.
  void Lose() {
    lost = true;
    cancellation.Cancel();
  }
};

// Keeps the holds of a process alive: tells the servers every third of a lease that each job makes progress, and looks
// whether somebody else has it or wants its end. A hold that the servers did not confirm for the time of a lease is
// lost, since they may have given its job to another. One thread. Thread-safe.
class LeaseKeeper {
 public:
  // `parts` outlives it.
  static absl::StatusOr<std::unique_ptr<LeaseKeeper>> Start(QueueParts& parts);
  ~LeaseKeeper();

  // Until Remove. The hold is shared with the keeper's thread, which may be looking at it.
  void Add(std::shared_ptr<Hold> hold);
  void Remove(const Hold& hold);

  // Looks at the job now.
  void Look(const std::string& job_id);
  // Looks at all, after the connection was gone.
  void LookAtAll();

 private:
  struct Kept {
    std::shared_ptr<Hold> hold;
    // When the last progress that was confirmed was sent, and when the next is due.
    absl::Duration confirmed;
    absl::Duration due;
  };
  LeaseKeeper(QueueParts& parts, std::unique_ptr<NatsInbox> inbox);
  void Run();
  absl::Duration SendDue();
  absl::Status Send(int64_t key, const Kept& kept, absl::Duration now);
  void Receive(const NatsMessage& message);
  void ReceiveRecord(Hold& hold, const NatsMessage& message);

  QueueParts& parts_;
  const std::unique_ptr<NatsInbox> inbox_;
  std::mutex mutex_;
  std::map<int64_t, Kept> kept_;
  int64_t next_key_ = 1;
  std::thread thread_;
};

}  // namespace flair::orchestrator
