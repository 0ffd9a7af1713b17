// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// Queries that delete jobs and the artifacts that no job has then. An artifact goes in two steps, so that no kill in
// between leaves a job without what it has: first, with the last job that has it, its results are removed and a
// tombstone is written (deleted_artifacts); then it is deleted, in a transaction that finds that still no job has it. A
// run that took it before that and records it after sees the tombstone (WasDeleted). Each call is part of a transaction
// of the caller's, but where it says otherwise. Thread-safe.
class DeletionTable {
 public:
  explicit DeletionTable(Database& database) : database_(database) {}

  // Forgets a job with all that belongs to it.
  absl::Status RemoveJob(const std::string& job_id);
  absl::Status RemoveBatch(const std::string& batch_id);

  // At most `limit` artifacts that wait for their deletion.
  absl::StatusOr<std::vector<std::string>> Pending(int limit);
  // Whether a job has the artifact.
  absl::StatusOr<bool> IsUsed(const std::string& artifact_id);
  // It needs no deletion any more: a job has it.
  absl::Status Keep(const std::string& artifact_id);
  // It has been deleted, or may have been.
  absl::Status SetDeleted(const std::string& artifact_id);

  // Whether there is any tombstone; most of the time there is none. No transaction needed.
  absl::StatusOr<bool> Any();

  // Whether the artifact may have been deleted since the run of the job began. No transaction needed.
  absl::StatusOr<bool> WasDeleted(const std::string& artifact_id, const std::string& job_id);

  // Removes tombstones that no run may have missed.
  absl::Status Trim();

  // Jobs without a batch that ended before a time, the oldest first. No transaction needed.
  absl::StatusOr<std::vector<std::string>> JobsEndedBefore(absl::Time time, int limit);
  // At most `limit` closed batches with ids above `after`, by id. No transaction needed.
  absl::StatusOr<std::vector<std::string>> ClosedBatches(const std::string& after, int limit);
  // When the last job of the batch ended; when it was made if it has none that ended. No transaction needed.
  absl::StatusOr<absl::Time> LastEndOf(const std::string& batch_id);

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
