// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "orchestrator/batch/repeater.h"
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
  // The run itself returns or ends the job: a record without its name is then no loss of the lease.
  std::atomic<bool> closing = false;

  // Another run may have the job; notifies the run.
  void Lose() {
    lost = true;
    cancellation.Cancel();
  }
};

// Keeps the holds of a process alive: reports progress of each job every third of a lease, and checks whether another
// process has taken the job or wants to end it. A hold is lost if the servers did not confirm progress for a whole
// lease, since they may have delivered its job to another process. One thread. Thread-safe.
class LeaseKeeper {
 public:
  // `parts` outlives it.
  explicit LeaseKeeper(QueueParts& parts) : parts_(parts) {}

  // Until Remove. The hold is shared with the keeper's thread, which may be looking at it.
  void Add(std::shared_ptr<Hold> hold) {
    const absl::Duration now = parts_.clock.Elapsed();
    std::lock_guard lock(mutex_);
    kept_.push_back({std::move(hold), now, now + parts_.lease / 3});
  }

  void Remove(const Hold& hold) {
    std::lock_guard lock(mutex_);
    std::erase_if(kept_, [&](const Kept& kept) { return kept.hold.get() == &hold; });
  }

  // Checks the job now; all jobs if the id is empty, after the connection was lost.
  void Look(const std::string& job_id) {
    {
      std::lock_guard lock(mutex_);
      for (Kept& kept : kept_) {
        if (job_id.empty() || kept.hold->job_id == job_id) kept.due = absl::ZeroDuration();
      }
    }
    keeper_.Wake();
  }

 private:
  // Progress that was not confirmed is reported again so soon.
  static constexpr absl::Duration kAgain = absl::Milliseconds(500);
  // How long one answer may take; at most a third of the lease.
  static constexpr absl::Duration kAnswer = absl::Seconds(1);
  // While a record cannot be read, others are not tried for so long: reports of progress must not wait for them.
  static constexpr absl::Duration kNoLooks = absl::Seconds(2);

  struct Kept {
    std::shared_ptr<Hold> hold;
    // When the last progress that was confirmed was reported, and when the next report is due.
    absl::Duration confirmed;
    absl::Duration due;
  };
  // Looks after the hold that is due next; says when another one is.
  absl::Duration Step() {
    LoseExpired();
    const absl::Duration now = parts_.clock.Elapsed();
    std::shared_ptr<Hold> hold;
    {
      std::lock_guard lock(mutex_);
      const auto next = std::ranges::min_element(kept_, {}, &Kept::due);
      // A hold that comes meanwhile is first due after a third of the lease.
      if (next == kept_.end()) return parts_.lease / 6;
      if (next->due > now) return std::min(parts_.lease / 6, next->due - now) + absl::Milliseconds(1);
      hold = next->hold;
      next->due = now + std::min(parts_.lease / 3, kAgain);
    }
    const bool confirmed = ReportProgress(*hold);
    LookAtRecord(*hold);
    std::lock_guard lock(mutex_);
    const auto kept = std::ranges::find(kept_, hold, &Kept::hold);
    if (kept == kept_.end() || !confirmed) return absl::ZeroDuration();
    kept->confirmed = now;
    // Unless another check was requested meanwhile.
    if (kept->due != absl::ZeroDuration()) kept->due = now + parts_.lease / 3;
    return absl::ZeroDuration();
  }

  // Gives up holds that were not confirmed for too long: the servers may deliver their jobs to others.
  void LoseExpired() {
    std::vector<std::shared_ptr<Hold>> lost;
    {
      std::lock_guard lock(mutex_);
      const absl::Duration now = parts_.clock.Elapsed();
      std::erase_if(kept_, [&](const Kept& kept) {
        if (!kept.hold->lost && now - kept.confirmed <= parts_.lease) return false;
        lost.push_back(kept.hold);
        return true;
      });
    }
    for (const std::shared_ptr<Hold>& hold : lost) hold->Lose();
  }

  bool ReportProgress(const Hold& hold) {
    const absl::Duration limit = std::min(kAnswer, parts_.lease / 3);
    return parts_.connection->Request({hold.acknowledge, "+WPI", {}}, limit).ok();
  }

  void LookAtRecord(Hold& hold) {
    if (parts_.clock.Elapsed() < look_from_) return;
    const absl::StatusOr<RevisedJob> record =
        parts_.ParseJob(hold.job_id, parts_.jobs.GetOnce(hold.job_id, std::min(kAnswer, parts_.lease / 3)));
    if (absl::IsUnavailable(record.status()))
      look_from_ = parts_.clock.Elapsed() + std::min(kNoLooks, parts_.lease / 3);
    if (!record.ok() || hold.closing) return;
    if (record->value.holder() != hold.holder) {
      hold.Lose();
    } else if (record->value.cancel_requested() && !hold.cancel_requested) {
      hold.cancel_requested = true;
      hold.cancellation.Cancel();
    }
  }

  QueueParts& parts_;
  // When records may be read again after one could not be.
  absl::Duration look_from_;
  std::mutex mutex_;
  std::vector<Kept> kept_;
  Repeater keeper_{[this] { return Step(); }};
};

}  // namespace flair::orchestrator
