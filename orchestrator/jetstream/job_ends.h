// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/queue_parts.h"

namespace flair::orchestrator {

// The ends of batches' jobs, in the order in which they came. The record of a job says that it has ended; what is here
// follows from it, and may be published again. How a job ended is in its subject, so that servers count by it. Errors
// as JetStreamApi. Thread-safe.
class JobEnds {
 public:
  explicit JobEnds(QueueParts& parts) : parts_(parts) {}

  // Jobs that have ended; those that stand alone, and those that are there already, are passed over.
  absl::Status Publish(std::span<const v1::Job> jobs);

  // Takes back the end of a failed job.
  absl::Status Remove(const v1::Job& job);

  // Fills in the counts of a batch but running_count.
  absl::Status Count(v1::Batch& batch);
  absl::StatusOr<int64_t> CountAll(const v1::Batch& batch);

  // The job of the batch that ended last; empty when none has.
  absl::StatusOr<std::string> LastOf(const std::string& batch_id);

  // Under which the end of the job is.
  std::string SubjectOf(const v1::Job& job) const;

  absl::StatusOr<std::vector<BatchEnd>> After(const std::string& batch_id, int64_t sequence, int limit);

  // The jobs that ended so, by id, those with larger ids first.
  absl::StatusOr<std::vector<std::string>> JobsIn(const std::string& batch_id, v1::JobState state);

 private:
  // The numbers of state and failure kind, as in subjects.
  using Outcome = std::pair<std::string, std::string>;
  absl::StatusOr<std::map<Outcome, int64_t>> CountOutcomes(const v1::Batch& batch);
  absl::StatusOr<std::vector<BatchEnd>> Read(const std::string& filter, int64_t sequence, int limit);

  QueueParts& parts_;
};

}  // namespace flair::orchestrator
