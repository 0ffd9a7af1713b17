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

// Queries that forget jobs and the artifacts that nobody has then. An artifact goes in two steps, so that no kill in
// between leaves a job without what it has: first, with the last job that has it, it is not found again by anybody and
// waits for its deletion; then it is deleted, in a transaction that finds that still nobody has it. A run that took it
// before that and records it after is told so (WasDeleted). Each call is part of a transaction of the caller's, but
// where it says otherwise. Thread-safe.
class DeletionTable {
 public:
  explicit DeletionTable(Database& database) : database_(database) {}

  // Forgets a job with all that belongs to it.
  absl::Status RemoveJob(const std::string& job_id);
  absl::Status RemoveBatch(const std::string& batch_id);

  // At most `limit` artifacts that wait for their deletion.
  absl::StatusOr<std::vector<std::string>> Pending(int limit);
  // Whether a job has the artifact, of those with the brief that is remembered with its deletion.
  absl::StatusOr<bool> IsHad(const std::string& artifact_id);
  // It needs no deletion any more: a job has it.
  absl::Status Spare(const std::string& artifact_id);
  // It has been deleted, or may have been.
  absl::Status SetDeleted(const std::string& artifact_id);

  // Whether any deletion is remembered; most of the time none is. No transaction needed.
  absl::StatusOr<bool> Any();

  // Whether the artifact may have been deleted since the run of the job began. No transaction needed.
  absl::StatusOr<bool> WasDeleted(const std::string& artifact_id, const std::string& job_id);

  // Forgets deletions that no run may have missed.
  absl::Status Trim();

  // Alone standing jobs that ended before a time, oldest ends first. No transaction needed.
  absl::StatusOr<std::vector<std::string>> JobsEndedBefore(absl::Time time, int limit);
  // At most `limit` closed batches with ids above `after`, by id. No transaction needed.
  absl::StatusOr<std::vector<std::string>> ClosedBatches(const std::string& after, int limit);
  // When the last job of the batch ended; when it was made if it has none that ended. No transaction needed.
  absl::StatusOr<absl::Time> LastEndOf(const std::string& batch_id);

 private:
  absl::Status Run(std::string_view sql, const std::string& id);
  absl::StatusOr<std::string> BriefOf(const std::string& job_id);
  absl::StatusOr<bool> IsHad(const std::string& brief, const std::string& artifact_id);
  // Nobody has the artifact any more, which begins with that brief.
  absl::Status Doom(const std::string& brief, const std::string& artifact_id);

  Database& database_;
};

}  // namespace flair::orchestrator
