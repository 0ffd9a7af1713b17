// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/util/time_util.h>

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/database.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// The columns that ReadBatch reads, in its order.
#define BATCH_COLUMNS "id, job_count, state, open, label, create_time_us, caller"

// Queries about batches, and the order in which their jobs ended. Each call is one step for other processes; to join
// several, hold a Transaction. Thread-safe.
class BatchTable {
 public:
  explicit BatchTable(Database& database) : database_(database) {}

  // ALREADY_EXISTS when the id or the request id is taken.
  absl::Status Insert(const store::v1::BatchRecord& record) {
    const v1::Batch& batch = record.batch();
    return database_.Run(
        "INSERT INTO batches (id, request_id, specs_digest, state, open, label, create_time_us, caller) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
        batch.id(), record.request_id(), record.specs_digest(), batch.state(), batch.open(), batch.label(),
        google::protobuf::util::TimeUtil::TimestampToMicroseconds(batch.create_time()), batch.owner());
  }

  // The batch that a request made; nothing when none.
  absl::StatusOr<std::optional<store::v1::BatchRecord>> FindByRequest(const std::string& request_id) {
    const auto lock = database_.lock();
    Statement select =
        database_.Prepare("SELECT " BATCH_COLUMNS ", specs_digest FROM batches WHERE request_id = ?", request_id);
    ASSIGN_OR_RETURN(const bool found, select.Step());
    if (!found) return std::nullopt;
    store::v1::BatchRecord record;
    ASSIGN_OR_RETURN(*record.mutable_batch(), ReadBatch(select));
    record.set_request_id(request_id);
    record.set_specs_digest(select.Text(7));
    return record;
  }

  // Without counts by state. NOT_FOUND when unknown.
  absl::StatusOr<v1::Batch> Get(const std::string& id) {
    const auto lock = database_.lock();
    Statement select = database_.Prepare("SELECT " BATCH_COLUMNS " FROM batches WHERE id = ?", id);
    ASSIGN_OR_RETURN(const bool found, select.Step());
    if (!found) return NotFound("batch_id: no batch \"{}\" in this store", id.substr(0, 80));
    return ReadBatch(select);
  }

  // With the counts of its jobs.
  absl::StatusOr<v1::Batch> GetWithCounts(const std::string& id) {
    const auto lock = database_.lock();
    ASSIGN_OR_RETURN(v1::Batch batch, Get(id));
    Statement count = database_.Prepare(
        "SELECT state, failure_kind, count(*) FROM jobs WHERE batch_id != '' AND batch_id = ? "
        "GROUP BY state, failure_kind",
        id);
    EndCounts ends;
    while (true) {
      ASSIGN_OR_RETURN(const bool row, count.Step());
      if (!row) break;
      const auto state = static_cast<v1::JobState>(count.Int(0));
      const auto jobs = static_cast<int>(count.Int(2));
      if (state == v1::JOB_STATE_RUNNING) batch.set_running_count(jobs);
      ends[{state, static_cast<v1::FailureKind>(count.Int(1))}] = jobs;
    }
    SetCounts(ends, batch);
    return batch;
  }

  // Newest first, without counts by state.
  absl::StatusOr<std::vector<v1::Batch>> List(const ListFilter& filter) {
    const auto lock = database_.lock();
    return ReadRows<v1::Batch>(
        database_.Prepare(
            "SELECT " BATCH_COLUMNS
            " FROM batches WHERE (?1 = '' OR id < ?1) AND (?2 = 0 OR caller = ?3) ORDER BY id DESC LIMIT ?4",
            filter.before, filter.owner.has_value(), filter.owner.value_or(""), filter.limit),
        ReadBatch);
  }

  // Stores what a rule made of a batch.
  absl::Status Save(const v1::Batch& batch) {
    return database_.Run("UPDATE batches SET state = ?, job_count = ?, open = ? WHERE id = ?", batch.state(),
                         batch.job_count(), batch.open(), batch.id());
  }

  // Puts the end of a job behind all others; forgets it.
  absl::Status AddEnd(const std::string& batch_id, const std::string& job_id) {
    const auto lock = database_.lock();
    RETURN_IF_ERROR(RemoveEnd(job_id));
    return database_.Run("INSERT INTO ends (batch_id, job_id) VALUES (?, ?)", batch_id, job_id);
  }

  absl::Status RemoveEnd(const std::string& job_id) {
    return database_.Run("DELETE FROM ends WHERE job_id = ?", job_id);
  }

  absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit) {
    const auto lock = database_.lock();
    return ReadRows<BatchEnd>(
        database_.Prepare(
            "SELECT sequence, job_id FROM ends WHERE batch_id = ? AND sequence > ? ORDER BY sequence LIMIT ?", batch_id,
            sequence, limit),
        [](const Statement& row) -> absl::StatusOr<BatchEnd> {
          return BatchEnd{row.Int(0), row.Text(1)};
        });
  }

 private:
  static absl::StatusOr<v1::Batch> ReadBatch(const Statement& row) {
    v1::Batch batch;
    batch.set_id(row.Text(0));
    batch.set_job_count(static_cast<int>(row.Int(1)));
    batch.set_state(static_cast<v1::BatchState>(row.Int(2)));
    batch.set_open(row.Int(3) != 0);
    batch.set_label(row.Text(4));
    *batch.mutable_create_time() = google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(row.Int(5));
    batch.set_owner(row.Text(6));
    return batch;
  }

  Database& database_;
};

#undef BATCH_COLUMNS

// Queries that delete jobs and the artifacts that no job has then. An artifact goes in two steps, so that no kill in
// between leaves a job without what it has: first, with the last job that has it, its results are removed and a
// tombstone is written (deleted_artifacts); then it is deleted, in a transaction that finds that still no job has it. A
// run that took it before that and records it after sees the tombstone (WasDeleted). Each call is part of a transaction
// of the caller's, but where it says otherwise. Thread-safe.
class DeletionTable {
 public:
  explicit DeletionTable(Database& database) : database_(database) {}

  // Forgets a job with all that belongs to it.
  absl::Status RemoveJob(const std::string& job_id) {
    const auto lock = database_.lock();
    ASSIGN_OR_RETURN(const std::vector<std::string> artifact_ids,
                     database_.Texts("SELECT artifact_id FROM job_artifacts WHERE job_id = ?", job_id));
    RETURN_IF_ERROR(database_.Run("DELETE FROM job_artifacts WHERE job_id = ?", job_id));
    for (const std::string& id : artifact_ids) {
      ASSIGN_OR_RETURN(const bool used, IsUsed(id));
      if (used) continue;
      RETURN_IF_ERROR(database_.Run("DELETE FROM results WHERE artifact_id = ?", id));
      RETURN_IF_ERROR(
          database_.Run("INSERT OR REPLACE INTO deleted_artifacts (artifact_id, pending) VALUES (?, 1)", id));
    }
    RETURN_IF_ERROR(database_.Run("DELETE FROM events WHERE job_id = ?", job_id));
    RETURN_IF_ERROR(database_.Run("DELETE FROM ends WHERE job_id = ?", job_id));
    return database_.Run("DELETE FROM jobs WHERE id = ?", job_id);
  }

  absl::Status RemoveBatch(const std::string& batch_id) {
    return database_.Run("DELETE FROM batches WHERE id = ?", batch_id);
  }

  // At most `limit` artifacts that wait for their deletion.
  absl::StatusOr<std::vector<std::string>> Pending(int limit) {
    return database_.Texts("SELECT artifact_id FROM deleted_artifacts WHERE pending = 1 ORDER BY sequence LIMIT ?",
                           limit);
  }

  // Whether a job has the artifact.
  absl::StatusOr<bool> IsUsed(const std::string& artifact_id) {
    return database_.Exists("SELECT 1 FROM job_artifacts WHERE artifact_id = ? LIMIT 1", artifact_id);
  }

  // It needs no deletion any more: a job has it.
  absl::Status Keep(const std::string& artifact_id) {
    return database_.Run("DELETE FROM deleted_artifacts WHERE artifact_id = ?", artifact_id);
  }

  // It has been deleted, or may have been.
  absl::Status SetDeleted(const std::string& artifact_id) {
    // With a new sequence: later than the beginning of every run there is.
    return database_.Run("INSERT OR REPLACE INTO deleted_artifacts (artifact_id, pending) VALUES (?, 0)", artifact_id);
  }

  // A run of the job begins: what is deleted from now on, it may miss.
  absl::Status BeginRun(const std::string& job_id) {
    return database_.Run(
        "UPDATE jobs SET deletions_seen = (SELECT coalesce(max(seq), 0) FROM sqlite_sequence WHERE name = "
        "'deleted_artifacts') WHERE id = ?",
        job_id);
  }

  // Whether there is any tombstone; most of the time there is none. No transaction needed.
  absl::StatusOr<bool> Any() { return database_.Exists("SELECT 1 FROM deleted_artifacts LIMIT 1"); }

  // Whether the artifact may have been deleted since the run of the job began. No transaction needed.
  absl::StatusOr<bool> WasDeleted(const std::string& artifact_id, const std::string& job_id) {
    return database_.Exists(
        "SELECT 1 FROM deleted_artifacts WHERE artifact_id = ? AND (pending = 1 OR sequence > "
        "(SELECT deletions_seen FROM jobs WHERE id = ?))",
        artifact_id, job_id);
  }

  // Removes tombstones that no run may have missed.
  absl::Status Trim() {
    return database_.Run(
        "DELETE FROM deleted_artifacts WHERE pending = 0 AND sequence <= "
        "(SELECT coalesce(min(deletions_seen), 9223372036854775807) FROM jobs WHERE state = 2)");
  }

  // Jobs without a batch that ended before a time, the oldest first. No transaction needed.
  absl::StatusOr<std::vector<std::string>> JobsEndedBefore(absl::Time time, int limit) {
    return database_.Texts(
        "SELECT id FROM jobs WHERE batch_id = '' AND state > 2 AND end_time_us < ? ORDER BY end_time_us, id LIMIT ?",
        absl::ToUnixMicros(time), limit);
  }

  // At most `limit` closed batches with ids above `after`, by id. No transaction needed.
  absl::StatusOr<std::vector<std::string>> ClosedBatches(const std::string& after, int limit) {
    return database_.Texts("SELECT id FROM batches WHERE id > ? AND open = 0 ORDER BY id LIMIT ?", after, limit);
  }

  // When the last job of the batch ended; when it was made if it has none that ended. No transaction needed.
  absl::StatusOr<absl::Time> LastEndOf(const std::string& batch_id) {
    ASSIGN_OR_RETURN(
        const int64_t time_us,
        database_.FirstInt("SELECT coalesce((SELECT end_time_us FROM jobs WHERE id = "
                           "(SELECT job_id FROM ends WHERE batch_id = ?1 ORDER BY sequence DESC LIMIT 1)), "
                           "(SELECT create_time_us FROM batches WHERE id = ?1))",
                           batch_id));
    return absl::FromUnixMicros(time_us);
  }

 private:
  Database& database_;
};

}  // namespace flair::orchestrator
