// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/access/access_control.h"
#include "orchestrator/batch/work_queue.h"

namespace flair::orchestrator {

// Sees to it that jobs which are added stay within the limits: the queue's and each caller's. Exact for all calls of
// this process: what one call may add and has not added yet, no other may. Other orchestrators of the same queue count
// for themselves, so a caller who asks several at once may get as much from each. Thread-safe.
class JobAdmission {
 public:
  // The queue outlives it.
  JobAdmission(WorkQueue& queue, int64_t queued_job_limit) : queue_(queue), queued_job_limit_(queued_job_limit) {}

  // A call that adds jobs, from before they are counted until it has added them.
  class Entry {
   public:
    // Waits for other calls of a caller who has a limit of their own. The admission outlives it; the caller too.
    Entry(JobAdmission& admission, const Caller& caller);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

    // OK when the call may add `job_count` jobs in all; else RESOURCE_EXHAUSTED, saying which limit they are over.
    absl::Status Grant(int64_t job_count);
    // How many of so many jobs the call may add, from 0 on.
    absl::StatusOr<int64_t> GrantSome(int64_t job_count);

   private:
    struct Counts {
      int64_t queued = 0;
      int64_t open = 0;
    };
    // Keeps so much from the others, and counts what is there and kept by them.
    absl::StatusOr<Counts> Keep(int64_t job_count);
    absl::Status Check(const Counts& counts, int64_t job_count) const;

    JobAdmission& admission_;
    const Caller& caller_;
    // Held while the call lasts; null when the caller has no limit.
    std::shared_ptr<std::mutex> turn_;
    int64_t kept_ = 0;
  };

 private:
  std::shared_ptr<std::mutex> TurnOf(const std::string& owner);

  WorkQueue& queue_;
  const int64_t queued_job_limit_;
  std::mutex mutex_;
  // By calls that have not ended.
  int64_t kept_ = 0;
  // Of the owners of which calls are under way.
  std::map<std::string, std::weak_ptr<std::mutex>> turns_;
};

}  // namespace flair::orchestrator
