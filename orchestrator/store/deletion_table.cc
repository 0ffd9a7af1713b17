// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/deletion_table.h"

namespace flair::orchestrator {

absl::Status DeletionTable::RemoveJob(const std::string& job_id) {
  const auto lock = database_.lock();
  ASSIGN_OR_RETURN(const std::vector<std::string> artifact_ids,
                   database_.Texts("SELECT artifact_id FROM job_artifacts WHERE job_id = ?", job_id));
  RETURN_IF_ERROR(database_.Run("DELETE FROM job_artifacts WHERE job_id = ?", job_id));
  for (const std::string& id : artifact_ids) {
    ASSIGN_OR_RETURN(const bool used, IsUsed(id));
    if (used) continue;
    RETURN_IF_ERROR(database_.Run("DELETE FROM results WHERE artifact_id = ?", id));
    RETURN_IF_ERROR(database_.Run("INSERT OR REPLACE INTO deleted_artifacts (artifact_id, pending) VALUES (?, 1)", id));
  }
  RETURN_IF_ERROR(database_.Run("DELETE FROM events WHERE job_id = ?", job_id));
  RETURN_IF_ERROR(database_.Run("DELETE FROM ends WHERE job_id = ?", job_id));
  return database_.Run("DELETE FROM jobs WHERE id = ?", job_id);
}

absl::Status DeletionTable::RemoveBatch(const std::string& batch_id) {
  return database_.Run("DELETE FROM batches WHERE id = ?", batch_id);
}

absl::StatusOr<std::vector<std::string>> DeletionTable::Pending(int limit) {
  return database_.Texts("SELECT artifact_id FROM deleted_artifacts WHERE pending = 1 ORDER BY sequence LIMIT ?",
                         limit);
}

absl::StatusOr<bool> DeletionTable::IsUsed(const std::string& artifact_id) {
  return database_.Exists("SELECT 1 FROM job_artifacts WHERE artifact_id = ? LIMIT 1", artifact_id);
}

absl::Status DeletionTable::Keep(const std::string& artifact_id) {
  return database_.Run("DELETE FROM deleted_artifacts WHERE artifact_id = ?", artifact_id);
}

absl::Status DeletionTable::SetDeleted(const std::string& artifact_id) {
  // With a new sequence: later than the beginning of every run there is.
  return database_.Run("INSERT OR REPLACE INTO deleted_artifacts (artifact_id, pending) VALUES (?, 0)", artifact_id);
}

absl::StatusOr<bool> DeletionTable::Any() { return database_.Exists("SELECT 1 FROM deleted_artifacts LIMIT 1"); }

absl::StatusOr<bool> DeletionTable::WasDeleted(const std::string& artifact_id, const std::string& job_id) {
  return database_.Exists(
      "SELECT 1 FROM deleted_artifacts WHERE artifact_id = ? AND (pending = 1 OR sequence > "
      "(SELECT deletions_seen FROM jobs WHERE id = ?))",
      artifact_id, job_id);
}

absl::Status DeletionTable::Trim() {
  return database_.Run(
      "DELETE FROM deleted_artifacts WHERE pending = 0 AND sequence <= "
      "(SELECT coalesce(min(deletions_seen), 9223372036854775807) FROM jobs WHERE state = 2)");
}

absl::StatusOr<std::vector<std::string>> DeletionTable::JobsEndedBefore(absl::Time time, int limit) {
  return database_.Texts(
      "SELECT id FROM jobs WHERE batch_id = '' AND state > 2 AND end_time_us < ? ORDER BY end_time_us, id LIMIT ?",
      absl::ToUnixMicros(time), limit);
}

absl::StatusOr<std::vector<std::string>> DeletionTable::ClosedBatches(const std::string& after, int limit) {
  return database_.Texts("SELECT id FROM batches WHERE id > ? AND open = 0 ORDER BY id LIMIT ?", after, limit);
}

absl::StatusOr<absl::Time> DeletionTable::LastEndOf(const std::string& batch_id) {
  ASSIGN_OR_RETURN(const int64_t time_us,
                   database_.FirstInt("SELECT coalesce((SELECT end_time_us FROM jobs WHERE id = "
                                      "(SELECT job_id FROM ends WHERE batch_id = ?1 ORDER BY sequence DESC LIMIT 1)), "
                                      "(SELECT create_time_us FROM batches WHERE id = ?1))",
                                      batch_id));
  return absl::FromUnixMicros(time_us);
}

}  // namespace flair::orchestrator
