// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/deletion_table.h"

#include "orchestrator/store/artifact_table.h"
#include "orchestrator/store/digest_functions.h"

namespace flair::orchestrator {

absl::Status DeletionTable::Run(std::string_view sql, const std::string& id) {
  return database_.Prepare(sql).Bind(id).Run();
}

absl::Status DeletionTable::RemoveJob(const std::string& job_id) {
  const auto lock = database_.lock();
  const auto artifacts = ArtifactTable(database_).OfJob(job_id);
  if (!artifacts.ok()) return artifacts.status();
  const absl::StatusOr<std::string> brief = BriefOf(job_id);
  if (!brief.ok()) return brief.status();
  absl::Status status = Run("DELETE FROM job_artifacts WHERE job_id = ?", job_id);
  for (const v1::ArtifactRef& artifact : *artifacts) {
    if (!status.ok()) return status;
    const absl::StatusOr<bool> had = IsHad(*brief, artifact.id());
    if (!had.ok()) return had.status();
    if (!*had) status = Doom(*brief, artifact.id());
  }
  if (status.ok()) status = Run("DELETE FROM events WHERE job_id = ?", job_id);
  if (status.ok()) status = Run("DELETE FROM ends WHERE job_id = ?", job_id);
  if (status.ok()) status = Run("DELETE FROM jobs WHERE id = ?", job_id);
  return status;
}

absl::StatusOr<std::string> DeletionTable::BriefOf(const std::string& job_id) {
  Statement select = database_.Prepare("SELECT brief FROM job_artifacts WHERE job_id = ? LIMIT 1");
  const absl::StatusOr<bool> row = select.Bind(job_id).Step();
  if (!row.ok()) return row.status();
  return *row ? select.Bytes(0) : "";
}

absl::Status DeletionTable::Doom(const std::string& brief, const std::string& artifact_id) {
  const absl::Status status = database_.Prepare("DELETE FROM results WHERE brief = ? AND artifact_id = ?")
                                  .BindBytes(brief)
                                  .BindBytes(DigestBytes(artifact_id))
                                  .Run();
  if (!status.ok()) return status;
  return database_.Prepare("INSERT OR REPLACE INTO deleted_artifacts (artifact_id, pending, brief) VALUES (?, 1, ?)")
      .Bind(artifact_id)
      .BindBytes(brief)
      .Run();
}

absl::Status DeletionTable::RemoveBatch(const std::string& batch_id) {
  const auto lock = database_.lock();
  return Run("DELETE FROM batches WHERE id = ?", batch_id);
}

absl::StatusOr<std::vector<std::string>> DeletionTable::Pending(int limit) {
  const auto lock = database_.lock();
  Statement select =
      database_.Prepare("SELECT artifact_id FROM deleted_artifacts WHERE pending = 1 ORDER BY sequence LIMIT ?");
  return select.Bind(limit).Texts();
}

absl::StatusOr<bool> DeletionTable::IsHad(const std::string& artifact_id) {
  const auto lock = database_.lock();
  std::string brief;
  {
    Statement select = database_.Prepare("SELECT brief FROM deleted_artifacts WHERE artifact_id = ?");
    const absl::StatusOr<bool> row = select.Bind(artifact_id).Step();
    if (!row.ok()) return row.status();
    if (*row) brief = select.Bytes(0);
  }
  return IsHad(brief, artifact_id);
}

absl::StatusOr<bool> DeletionTable::IsHad(const std::string& brief, const std::string& artifact_id) {
  Statement select = database_.Prepare("SELECT 1 FROM job_artifacts WHERE brief = ? AND artifact_id = ? LIMIT 1");
  return select.BindBytes(brief).BindBytes(DigestBytes(artifact_id)).Step();
}

absl::Status DeletionTable::Spare(const std::string& artifact_id) {
  const auto lock = database_.lock();
  return Run("DELETE FROM deleted_artifacts WHERE artifact_id = ?", artifact_id);
}

absl::Status DeletionTable::SetDeleted(const std::string& artifact_id) {
  const auto lock = database_.lock();
  // With a new sequence: later than the beginning of every run there is.
  return Run("INSERT OR REPLACE INTO deleted_artifacts (artifact_id, pending) VALUES (?, 0)", artifact_id);
}

absl::StatusOr<bool> DeletionTable::Any() {
  const auto lock = database_.lock();
  return database_.Prepare("SELECT 1 FROM deleted_artifacts LIMIT 1").Step();
}

absl::StatusOr<bool> DeletionTable::WasDeleted(const std::string& artifact_id, const std::string& job_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT 1 FROM deleted_artifacts WHERE artifact_id = ? AND (pending = 1 OR sequence > "
      "(SELECT deletions_seen FROM jobs WHERE id = ?))");
  return select.Bind(artifact_id).Bind(job_id).Step();
}

absl::Status DeletionTable::Trim() {
  const auto lock = database_.lock();
  return database_
      .Prepare(
          "DELETE FROM deleted_artifacts WHERE pending = 0 AND sequence <= "
          "(SELECT coalesce(min(deletions_seen), 9223372036854775807) FROM jobs WHERE state = 2)")
      .Run();
}

absl::StatusOr<std::vector<std::string>> DeletionTable::JobsEndedBefore(absl::Time time, int limit) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT id FROM jobs WHERE batch_id = '' AND state > 2 AND end_time_us < ? ORDER BY end_time_us, id LIMIT ?");
  return select.Bind(absl::ToUnixMicros(time)).Bind(limit).Texts();
}

absl::StatusOr<std::vector<std::string>> DeletionTable::ClosedBatches(const std::string& after, int limit) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT id FROM batches WHERE id > ? AND open = 0 ORDER BY id LIMIT ?");
  return select.Bind(after).Bind(limit).Texts();
}

absl::StatusOr<absl::Time> DeletionTable::LastEndOf(const std::string& batch_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT coalesce((SELECT end_time_us FROM jobs WHERE id = "
      "(SELECT job_id FROM ends WHERE batch_id = ?1 ORDER BY sequence DESC LIMIT 1)), "
      "(SELECT create_time_us FROM batches WHERE id = ?1))");
  select.BindAt(1, batch_id);
  absl::StatusOr<bool> row = select.Step();
  if (!row.ok()) return row.status();
  return absl::FromUnixMicros(select.Int(0));
}

}  // namespace flair::orchestrator
