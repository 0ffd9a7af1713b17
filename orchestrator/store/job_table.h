// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/util/time_util.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/store/v1/job_record.pb.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/database.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// The columns that Read reads, in its order.
#define JOB_COLUMNS                                                                                               \
  "id, spec, state, stage, error, error_code, create_time_us, end_time_us, batch_id, batch_index, failure_kind, " \
  "attempt_count, caller"

// Queries about jobs, their events and artifacts, and what stages made before. Each call is one step for other
// processes; to join several, hold a Transaction. A Job read here has its artifacts too. Thread-safe.
class JobTable {
 public:
  explicit JobTable(Database& database) : database_(database) {}

  // A new QUEUED job; `request_id` empty for a job of a batch. ALREADY_EXISTS when its id or request id is taken.
  absl::Status Insert(const v1::Job& job, const std::string& request_id) {
    return database_.Run(
        "INSERT INTO jobs (id, request_id, spec, state, create_time_us, batch_id, batch_index, caller) "
        "VALUES (?, nullif(?, ''), ?, ?, ?, ?, ?, ?)",
        job.id(), request_id, Blob{runtime::CanonicalBytes(job.spec())}, v1::JOB_STATE_QUEUED,
        ToMicroseconds(job.create_time()), job.batch_id(), job.batch_index(), job.owner());
  }

  // NOT_FOUND when unknown.
  absl::StatusOr<v1::Job> Get(const std::string& id) {
    const auto lock = database_.lock();
    Statement select = database_.Prepare("SELECT " JOB_COLUMNS " FROM jobs WHERE id = ?", id);
    ASSIGN_OR_RETURN(const bool found, select.Step());
    if (!found) return NotFound("job_id: no job \"{}\" in this store", id.substr(0, 80));
    return Read(select);
  }

  // All that is known of a job but the request that made it. NOT_FOUND when unknown.
  absl::StatusOr<store::v1::JobRecord> Load(const std::string& id) {
    const auto lock = database_.lock();
    store::v1::JobRecord record;
    ASSIGN_OR_RETURN(*record.mutable_job(), Get(id));
    Statement select =
        database_.Prepare("SELECT owner, cancel_requested, not_before_us, lost_run_count FROM jobs WHERE id = ?", id);
    RETURN_IF_ERROR(select.Step().status());
    record.set_holder(select.Text(0));
    record.set_cancel_requested(select.Int(1) != 0);
    if (select.Int(2) != 0) *record.mutable_not_before_time() = ToTimestamp(select.Int(2));
    record.set_lost_run_count(static_cast<int>(select.Int(3)));
    // Again, each with its stage: of a damaged store, two reads may differ.
    record.mutable_job()->clear_artifacts();
    Statement stages = database_.Prepare(
        "SELECT artifact_id, kind, size_bytes, stage_index FROM job_artifacts WHERE job_id = ? ORDER BY stage_index",
        id);
    while (true) {
      ASSIGN_OR_RETURN(const bool row, stages.Step());
      if (!row) break;
      ASSIGN_OR_RETURN(*record.mutable_job()->add_artifacts(), ReadRef(stages));
      record.add_artifact_stages(static_cast<int>(stages.Int(3)));
    }
    ASSIGN_OR_RETURN(const std::vector<v1::JobEvent> events, EventsAfter(id, 0, std::numeric_limits<int>::max()));
    record.mutable_events()->Assign(events.begin(), events.end());
    return record;
  }

  // Stores what a rule made of a record that was loaded, with so many events, in the same transaction.
  absl::Status Save(const store::v1::JobRecord& record, int stored_events) {
    const auto lock = database_.lock();
    const v1::Job& job = record.job();
    RETURN_IF_ERROR(database_.Run(
        "UPDATE jobs SET state = ?, stage = ?, error = ?, error_code = ?, failure_kind = ?, end_time_us = ?, "
        "attempt_count = ?, owner = ?, cancel_requested = ?, not_before_us = ?, lost_run_count = ? WHERE id = ?",
        job.state(), job.stage(), job.error(), job.error_code(), job.failure_kind(), ToMicroseconds(job.end_time()),
        job.attempt_count(), record.holder(), record.cancel_requested(), ToMicroseconds(record.not_before_time()),
        record.lost_run_count(), job.id()));
    for (int i = 0; i < job.artifacts_size(); ++i) {
      const v1::ArtifactRef& artifact = job.artifacts(i);
      RETURN_IF_ERROR(database_.Run("INSERT OR REPLACE INTO job_artifacts VALUES (?, ?, ?, ?, ?)", job.id(),
                                    record.artifact_stages(i), artifact.id(), artifact.kind(), artifact.size_bytes()));
    }
    for (int i = stored_events; i < record.events_size(); ++i) {
      RETURN_IF_ERROR(database_.Run("INSERT INTO events VALUES (?, ?, ?)", job.id(), record.events(i).sequence(),
                                    Blob{runtime::CanonicalBytes(record.events(i))}));
    }
    return absl::OkStatus();
  }

  // Id of the job that a request made; empty when none.
  absl::StatusOr<std::string> FindByRequest(const std::string& request_id) {
    return database_.FirstText("SELECT id FROM jobs WHERE request_id = ?", request_id);
  }

  absl::StatusOr<std::vector<v1::Job>> List(const ListFilter& filter) {
    const auto lock = database_.lock();
    // Conditions that are not asked for are left out, so that each form of the query finds its index.
    std::string sql = "SELECT " JOB_COLUMNS " FROM jobs WHERE true";
    if (!filter.before.empty()) sql += " AND id < ?";
    if (!filter.batch_id.empty()) sql += " AND batch_id != '' AND batch_id = ?";
    if (filter.state != v1::JOB_STATE_UNSPECIFIED) sql += " AND state = ?";
    if (filter.owner.has_value())
      sql += filter.owner->empty() ? " AND caller = ''" : " AND caller != '' AND caller = ?";
    Statement select = database_.Prepare(sql + " ORDER BY id DESC LIMIT ?");
    if (!filter.before.empty()) select.Bind(filter.before);
    if (!filter.batch_id.empty()) select.Bind(filter.batch_id);
    if (filter.state != v1::JOB_STATE_UNSPECIFIED) select.Bind(filter.state);
    if (filter.owner.has_value() && !filter.owner->empty()) select.Bind(*filter.owner);
    select.Bind(filter.limit);
    return ReadRows<v1::Job>(std::move(select), [this](const Statement& row) { return Read(row); });
  }

  // Ids of at most `limit` jobs of a batch in a state.
  absl::StatusOr<std::vector<std::string>> IdsOf(const std::string& batch_id, v1::JobState state, int limit) {
    return database_.Texts(
        "SELECT id FROM jobs WHERE batch_id != '' AND batch_id = ? AND state = ? ORDER BY failure_kind, id LIMIT ?",
        batch_id, state, limit);
  }

  absl::StatusOr<int64_t> CountQueued() { return database_.FirstInt("SELECT count(*) FROM jobs WHERE state = 1"); }

  // QUEUED and RUNNING ones of one caller.
  absl::StatusOr<int64_t> CountOpen(const std::string& caller) {
    return database_.FirstInt("SELECT count(*) FROM jobs WHERE state IN (1, 2) AND caller != '' AND caller = ?",
                              caller);
  }

  // `caller` is not empty.
  absl::StatusOr<bool> OwnsArtifact(const std::string& caller, const std::string& artifact_id) {
    return database_.Exists(
        "SELECT 1 FROM job_artifacts JOIN jobs ON jobs.id = job_id WHERE artifact_id = ? AND caller = ? LIMIT 1",
        artifact_id, caller);
  }

  // The oldest QUEUED job of a batch ("": of none) that may run by `now`; empty when none.
  absl::StatusOr<std::string> OldestWaiting(const std::string& batch_id, absl::Time now) {
    return database_.FirstText(
        "SELECT id FROM jobs WHERE state = 1 AND batch_id = ? AND not_before_us <= ? ORDER BY id LIMIT 1", batch_id,
        absl::ToUnixMicros(now));
  }

  // The least id above `after` of a batch with QUEUED jobs; empty when none.
  absl::StatusOr<std::string> NextBatchWaiting(const std::string& after) {
    return database_.FirstText("SELECT batch_id FROM jobs WHERE state = 1 AND batch_id > ? ORDER BY batch_id LIMIT 1",
                               after);
  }

  // Whether a job waits for a time after `now`; one beyond the next hour is none of ours.
  absl::StatusOr<bool> AnyDelayed(absl::Time now) {
    return database_.Exists(
        "SELECT 1 FROM jobs WHERE state = 1 AND not_before_us > 0 AND not_before_us > ? AND not_before_us < ? LIMIT 1",
        absl::ToUnixMicros(now), absl::ToUnixMicros(now + absl::Hours(1)));
  }

  // Owners of RUNNING jobs.
  absl::StatusOr<std::vector<std::string>> Owners() {
    return database_.Texts("SELECT DISTINCT owner FROM jobs WHERE state = 2 ORDER BY owner");
  }

  // Makes the RUNNING jobs of an owner that runs none QUEUED again; how many they were.
  absl::StatusOr<int64_t> Release(const std::string& owner) {
    return database_.RunAndCount("UPDATE jobs SET state = 1, owner = '' WHERE state = 2 AND owner = ?", owner);
  }

  absl::StatusOr<bool> CancelRequested(const std::string& id) {
    return database_.Exists("SELECT 1 FROM jobs WHERE id = ? AND cancel_requested != 0", id);
  }

  // At most `limit` events after a sequence number, in order.
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence, int limit) {
    const auto lock = database_.lock();
    const auto read = [](const Statement& row) -> absl::StatusOr<v1::JobEvent> {
      v1::JobEvent event;
      // Of what has happened; the job goes on without it.
      if (!event.ParseFromString(row.Text(0))) {
        event.Clear();
        event.set_message("damaged in the store");
      }
      event.set_sequence(row.Int(1));
      return event;
    };
    return ReadRows<v1::JobEvent>(
        database_.Prepare(
            "SELECT event, sequence FROM events WHERE job_id = ? AND sequence > ? ORDER BY sequence LIMIT ?", job_id,
            sequence, limit),
        read);
  }

  // The artifacts of a job, in stage order.
  absl::StatusOr<std::vector<v1::ArtifactRef>> ArtifactsOf(const std::string& job_id) {
    const auto lock = database_.lock();
    return ReadRows<v1::ArtifactRef>(
        database_.Prepare(
            "SELECT artifact_id, kind, size_bytes FROM job_artifacts WHERE job_id = ? ORDER BY stage_index", job_id),
        ReadRef);
  }

  // What was made under a key of ResultKey(); nothing when nothing was. The latest result wins.
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key) {
    const auto lock = database_.lock();
    Statement select = database_.Prepare("SELECT artifact_id, kind, size_bytes FROM results WHERE key = ?", key);
    ASSIGN_OR_RETURN(const bool found, select.Step());
    if (!found) return std::nullopt;
    return ReadRef(select);
  }

  absl::Status SetResult(const std::string& key, const v1::ArtifactRef& artifact) {
    return database_.Run("INSERT OR REPLACE INTO results VALUES (?, ?, ?, ?)", key, artifact.id(), artifact.kind(),
                         artifact.size_bytes());
  }

 private:
  static google::protobuf::Timestamp ToTimestamp(int64_t microseconds) {
    return google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(microseconds);
  }
  static int64_t ToMicroseconds(const google::protobuf::Timestamp& time) {
    return google::protobuf::util::TimeUtil::TimestampToMicroseconds(time);
  }

  static absl::StatusOr<v1::ArtifactRef> ReadRef(const Statement& row) {
    v1::ArtifactRef ref;
    ref.set_id(row.Text(0));
    ref.set_kind(static_cast<v1::ArtifactKind>(row.Int(1)));
    ref.set_size_bytes(row.Int(2));
    return ref;
  }

  absl::StatusOr<v1::Job> Read(const Statement& row) {
    v1::Job job;
    job.set_id(row.Text(0));
    // Without it the job fails alone, and holds up no other.
    if (!job.mutable_spec()->ParseFromString(row.Text(1))) job.clear_spec();
    job.set_state(static_cast<v1::JobState>(row.Int(2)));
    job.set_stage(row.Text(3));
    job.set_error(row.Text(4));
    job.set_error_code(static_cast<int>(row.Int(5)));
    *job.mutable_create_time() = ToTimestamp(row.Int(6));
    if (row.Int(7) != 0) *job.mutable_end_time() = ToTimestamp(row.Int(7));
    job.set_batch_id(row.Text(8));
    job.set_batch_index(row.Int(9));
    job.set_failure_kind(static_cast<v1::FailureKind>(row.Int(10)));
    job.set_attempt_count(static_cast<int>(row.Int(11)));
    job.set_owner(row.Text(12));
    ASSIGN_OR_RETURN(const std::vector<v1::ArtifactRef> artifacts, ArtifactsOf(job.id()));
    job.mutable_artifacts()->Assign(artifacts.begin(), artifacts.end());
    return job;
  }

  Database& database_;
};

#undef JOB_COLUMNS

}  // namespace flair::orchestrator
