// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/jetstream/consumers.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// Sees to it that batches come to their end even when a process died between two steps: jobs of cancelled ones are
// ended, jobs whose message or end is missing get it, and a batch whose jobs have all ended takes nothing of the
// servers any more but its records. Everything here may be done by several processes at once and again. Thread-safe.
class BatchRepair {
 public:
  BatchRepair(QueueParts& parts, JobEnds& ends, Consumers& consumers)
      : parts_(parts), ends_(ends), consumers_(consumers) {}

  // Ends the jobs of a cancelled batch that wait, asks for the end of those that run.
  absl::Status CancelJobs(const std::string& batch_id, int64_t job_count, absl::Time now);

  // Removes the consumer of a batch that has come to its end. When it has not, although it is closed and nothing of it
  // is in the queue stream (`waits`: something is), repairs what is missing. Returns whether to look again without
  // being asked to: at a cancelled one, whose running jobs have yet to end.
  absl::StatusOr<bool> Close(const std::string& batch_id, bool waits);

 private:
  using Visit = std::function<absl::Status(std::vector<RevisedJob> jobs)>;
  absl::Status VisitJobs(const std::string& batch_id, int64_t job_count, const Visit& visit);
  absl::Status CancelThese(std::vector<RevisedJob> jobs, absl::Time now);
  absl::Status RepairThese(const std::vector<RevisedJob>& jobs);

  QueueParts& parts_;
  JobEnds& ends_;
  Consumers& consumers_;
};

}  // namespace flair::orchestrator
