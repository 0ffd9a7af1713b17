// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/database.h"
#include "orchestrator/store/job_table.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// One run of a job: who runs it, and the how manyth run it is. Writes for a run that has been superseded do not match
// any more.
struct JobHold {
  std::string job_id;
  std::string owner;
  int attempt = 0;
};

// The columns that Read reads, in its order.
#define JOB_COLUMNS                                                                                               \
  "id, spec, state, stage, error, error_code, create_time_us, end_time_us, batch_id, batch_index, failure_kind, " \
  "attempt_count, caller"

// Of the run that holds the job.
#define IF_HELD " WHERE id = ? AND state = 2 AND owner = ? AND attempt_count = ?"

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
        google::protobuf::util::TimeUtil::TimestampToMicroseconds(job.create_time()), job.batch_id(), job.batch_index(),
        job.owner());
  }

  // NOT_FOUND when unknown.
  absl::StatusOr<v1::Job> Get(const std::string& id) {
    const auto lock = database_.lock();
    Statement select = database_.Prepare("SELECT " JOB_COLUMNS " FROM jobs WHERE id = ?", id);
    ASSIGN_OR_RETURN(const bool found, select.Step());
    if (!found) return absl::NotFoundError(fmt::format("job_id: no job \"{}\" in this store", id.substr(0, 80)));
    return Read(select);
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

  // Whether a job waited for a time that has come by `now`.
  absl::StatusOr<bool> AnyDelayPassed(absl::Time now) {
    return database_.Exists("SELECT 1 FROM jobs WHERE state = 1 AND not_before_us > 0 AND not_before_us <= ? LIMIT 1",
                            absl::ToUnixMicros(now));
  }

  // Makes a QUEUED job RUNNING by `owner` in a new run; false when it is not QUEUED.
  absl::StatusOr<bool> Claim(const std::string& id, const std::string& owner) {
    return ChangesOne(
        "UPDATE jobs SET state = 2, owner = ?, attempt_count = attempt_count + 1, not_before_us = 0, "
        "lost_run_count = lost_run_count + 1, "
        "deletions_seen = (SELECT coalesce(max(seq), 0) FROM sqlite_sequence WHERE name = 'deleted_artifacts') "
        "WHERE id = ? AND state = 1",
        owner, id);
  }

  // Owners of RUNNING jobs.
  absl::StatusOr<std::vector<std::string>> Owners() {
    return database_.Texts("SELECT DISTINCT owner FROM jobs WHERE state = 2 ORDER BY owner");
  }

  // Makes the RUNNING jobs of a dead owner QUEUED again.
  absl::Status Release(const std::string& owner) {
    return database_.Run("UPDATE jobs SET state = 1, owner = '' WHERE state = 2 AND owner = ?", owner);
  }

  // Consecutive runs before the one that goes on whose process died and that stored nothing.
  absl::StatusOr<int64_t> LostRunCount(const std::string& id) {
    return database_.FirstInt("SELECT lost_run_count - (state = 2) FROM jobs WHERE id = ?", id);
  }

  // For the run that holds a RUNNING job; false, and nothing done, when another one does or none: its stage; QUEUED
  // again, not before some time; ended with job.state(), stage, error, failure_kind and end_time.
  absl::StatusOr<bool> SetStage(const JobHold& hold, const std::string& stage, bool made_something) {
    // 1: this run, which counts as lost until it says otherwise.
    return ChangesOne("UPDATE jobs SET stage = ?, lost_run_count = iif(?, 1, lost_run_count)" IF_HELD, stage,
                      made_something, hold.job_id, hold.owner, hold.attempt);
  }

  absl::StatusOr<bool> Requeue(const JobHold& hold, absl::Time not_before) {
    const int64_t not_before_us = not_before == absl::InfinitePast() ? 0 : absl::ToUnixMicros(not_before);
    return ChangesOne(
        "UPDATE jobs SET state = 1, owner = '', lost_run_count = lost_run_count - 1, not_before_us = ?" IF_HELD,
        not_before_us, hold.job_id, hold.owner, hold.attempt);
  }

  absl::StatusOr<bool> End(const JobHold& hold, const v1::Job& job) {
    return ChangesOne(
        "UPDATE jobs SET state = ?, stage = ?, error = ?, error_code = ?, failure_kind = ?, end_time_us = ?, "
        "owner = ''" IF_HELD,
        job.state(), job.stage(), job.error(), job.error_code(), job.failure_kind(),
        google::protobuf::util::TimeUtil::TimestampToMicroseconds(job.end_time()), hold.job_id, hold.owner,
        hold.attempt);
  }

  // Ends a QUEUED job as CANCELLED; false when it is not QUEUED.
  absl::StatusOr<bool> CancelWaiting(const std::string& id, absl::Time time) {
    return ChangesOne("UPDATE jobs SET state = 5, cancel_requested = 1, end_time_us = ? WHERE id = ? AND state = 1",
                      absl::ToUnixMicros(time), id);
  }

  // Makes a FAILED job QUEUED again; false when it is not FAILED.
  absl::StatusOr<bool> Retry(const std::string& id) {
    return ChangesOne(
        "UPDATE jobs SET state = 1, error = '', error_code = 0, failure_kind = 0, end_time_us = 0, not_before_us = 0, "
        "cancel_requested = 0, lost_run_count = 0 WHERE id = ? AND state = 4",
        id);
  }

  // Remembers that a job, or all RUNNING ones of a batch, are to be cancelled.
  absl::Status RequestCancel(const std::string& id) {
    return database_.Run("UPDATE jobs SET cancel_requested = 1 WHERE id = ?", id);
  }

  absl::Status RequestCancelOfBatch(const std::string& batch_id) {
    return database_.Run("UPDATE jobs SET cancel_requested = 1 WHERE batch_id != '' AND batch_id = ? AND state = 2",
                         batch_id);
  }

  absl::StatusOr<bool> CancelRequested(const std::string& id) {
    return database_.Exists("SELECT 1 FROM jobs WHERE id = ? AND cancel_requested != 0", id);
  }

  // Stores an event under the job's next sequence number.
  absl::Status AppendEvent(v1::JobEvent event) {
    const auto lock = database_.lock();
    ASSIGN_OR_RETURN(const int64_t last,
                     database_.FirstInt("SELECT max(sequence) FROM events WHERE job_id = ?", event.job_id()));
    event.set_sequence(last + 1);
    return database_.Run("INSERT INTO events VALUES (?, ?, ?)", event.job_id(), event.sequence(),
                         Blob{runtime::CanonicalBytes(event)});
  }

  // At most `limit` events after a sequence number, in order.
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence, int limit) {
    const auto lock = database_.lock();
    const auto read = [&job_id](const Statement& row) -> absl::StatusOr<v1::JobEvent> {
      v1::JobEvent event;
      if (event.ParseFromString(row.Text(0))) return event;
      return absl::DataLossError(fmt::format("job store: an event of job {} is damaged", job_id));
    };
    return ReadRows<v1::JobEvent>(
        database_.Prepare("SELECT event FROM events WHERE job_id = ? AND sequence > ? ORDER BY sequence LIMIT ?",
                          job_id, sequence, limit),
        read);
  }

  // The artifacts of a job, in stage order; a stage's new artifact replaces its old one.
  absl::StatusOr<std::vector<v1::ArtifactRef>> ArtifactsOf(const std::string& job_id) {
    const auto lock = database_.lock();
    return ReadRows<v1::ArtifactRef>(
        database_.Prepare(
            "SELECT artifact_id, kind, size_bytes FROM job_artifacts WHERE job_id = ? ORDER BY stage_index", job_id),
        ReadRef);
  }

  absl::Status Attach(const std::string& job_id, int stage_index, const v1::ArtifactRef& artifact) {
    return database_.Run("INSERT OR REPLACE INTO job_artifacts VALUES (?, ?, ?, ?, ?)", job_id, stage_index,
                         artifact.id(), artifact.kind(), artifact.size_bytes());
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
    if (!job.mutable_spec()->ParseFromString(row.Text(1))) {
      return absl::DataLossError(fmt::format("job store: the spec of job {} is damaged", job.id()));
    }
    job.set_state(static_cast<v1::JobState>(row.Int(2)));
    job.set_stage(row.Text(3));
    job.set_error(row.Text(4));
    job.set_error_code(static_cast<int>(row.Int(5)));
    *job.mutable_create_time() = google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(row.Int(6));
    if (row.Int(7) != 0)
      *job.mutable_end_time() = google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(row.Int(7));
    job.set_batch_id(row.Text(8));
    job.set_batch_index(row.Int(9));
    job.set_failure_kind(static_cast<v1::FailureKind>(row.Int(10)));
    job.set_attempt_count(static_cast<int>(row.Int(11)));
    job.set_owner(row.Text(12));
    ASSIGN_OR_RETURN(const std::vector<v1::ArtifactRef> artifacts, ArtifactsOf(job.id()));
    job.mutable_artifacts()->Assign(artifacts.begin(), artifacts.end());
    return job;
  }

  template <typename... Values>

  absl::StatusOr<bool> ChangesOne(std::string_view sql, const Values&... values) {
    ASSIGN_OR_RETURN(const int64_t changed, database_.RunAndCount(sql, values...));
    return changed == 1;
  }

  Database& database_;
};

#undef JOB_COLUMNS
#undef IF_HELD

}  // namespace flair::orchestrator
