// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/batch_table.h"
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
    if (!found) return absl::NotFoundError(fmt::format("batch_id: no batch \"{}\" in this store", id.substr(0, 80)));
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
    while (true) {
      ASSIGN_OR_RETURN(const bool row, count.Step());
      if (!row) break;
      AddCount(static_cast<v1::JobState>(count.Int(0)), static_cast<v1::FailureKind>(count.Int(1)),
               static_cast<int>(count.Int(2)), batch);
    }
    std::ranges::stable_sort(*batch.mutable_failures(), std::greater(), &v1::FailureCount::job_count);
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

  absl::Status SetState(const std::string& id, v1::BatchState state) {
    return database_.Run("UPDATE batches SET state = ? WHERE id = ?", state, id);
  }

  absl::Status SetJobs(const std::string& id, int64_t job_count, bool open) {
    return database_.Run("UPDATE batches SET job_count = ?, open = ? WHERE id = ?", job_count, open, id);
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

  static void AddCount(v1::JobState state, v1::FailureKind kind, int jobs, v1::Batch& batch) {
    switch (state) {
      case v1::JOB_STATE_SUCCEEDED:
        batch.set_succeeded_count(batch.succeeded_count() + jobs);
        break;
      case v1::JOB_STATE_FAILED: {
        batch.set_failed_count(batch.failed_count() + jobs);
        v1::FailureCount& count = *batch.add_failures();
        count.set_kind(kind);
        count.set_job_count(jobs);
        break;
      }
      case v1::JOB_STATE_CANCELLED:
        batch.set_cancelled_count(batch.cancelled_count() + jobs);
        break;
      default:
        if (state == v1::JOB_STATE_RUNNING) batch.set_running_count(batch.running_count() + jobs);
        batch.set_open_count(batch.open_count() + jobs);
    }
  }

  Database& database_;
};

#undef BATCH_COLUMNS

}  // namespace flair::orchestrator
