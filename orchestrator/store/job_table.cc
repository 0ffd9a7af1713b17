// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/job_table.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

using google::protobuf::util::TimeUtil;

// The columns that Read reads, in its order.
#define JOB_COLUMNS                                                                                               \
  "id, spec, state, stage, error, error_code, create_time_us, end_time_us, batch_id, batch_index, failure_kind, " \
  "attempt_count, caller"

// Of the run that holds the job.
#define IF_HELD " WHERE id = ? AND state = 2 AND owner = ? AND attempt_count = ?"

absl::StatusOr<v1::ArtifactRef> ReadRef(const Statement& row) {
  v1::ArtifactRef ref;
  ref.set_id(row.Text(0));
  ref.set_kind(static_cast<v1::ArtifactKind>(row.Int(1)));
  ref.set_size_bytes(row.Int(2));
  return ref;
}

}  // namespace

template <typename... Values>
absl::StatusOr<bool> JobTable::ChangesOne(std::string_view sql, const Values&... values) {
  ASSIGN_OR_RETURN(const int64_t changed, database_.RunAndCount(sql, values...));
  return changed == 1;
}

absl::Status JobTable::Insert(const v1::Job& job, const std::string& request_id) {
  return database_.Run(
      "INSERT INTO jobs (id, request_id, spec, state, create_time_us, batch_id, batch_index, caller) "
      "VALUES (?, nullif(?, ''), ?, ?, ?, ?, ?, ?)",
      job.id(), request_id, Blob{runtime::CanonicalBytes(job.spec())}, v1::JOB_STATE_QUEUED,
      TimeUtil::TimestampToMicroseconds(job.create_time()), job.batch_id(), job.batch_index(), job.owner());
}

absl::StatusOr<v1::Job> JobTable::Get(const std::string& id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT " JOB_COLUMNS " FROM jobs WHERE id = ?", id);
  ASSIGN_OR_RETURN(const bool found, select.Step());
  if (!found) return absl::NotFoundError(fmt::format("job_id: no job \"{}\" in this store", id.substr(0, 80)));
  return Read(select);
}

absl::StatusOr<std::string> JobTable::FindByRequest(const std::string& request_id) {
  return database_.FirstText("SELECT id FROM jobs WHERE request_id = ?", request_id);
}

absl::StatusOr<std::vector<v1::Job>> JobTable::List(const ListFilter& filter) {
  const auto lock = database_.lock();
  // Conditions that are not asked for are left out, so that each form of the query finds its index.
  std::string sql = "SELECT " JOB_COLUMNS " FROM jobs WHERE true";
  if (!filter.before.empty()) sql += " AND id < ?";
  if (!filter.batch_id.empty()) sql += " AND batch_id != '' AND batch_id = ?";
  if (filter.state != v1::JOB_STATE_UNSPECIFIED) sql += " AND state = ?";
  if (filter.owner.has_value()) sql += filter.owner->empty() ? " AND caller = ''" : " AND caller != '' AND caller = ?";
  Statement select = database_.Prepare(sql + " ORDER BY id DESC LIMIT ?");
  if (!filter.before.empty()) select.Bind(filter.before);
  if (!filter.batch_id.empty()) select.Bind(filter.batch_id);
  if (filter.state != v1::JOB_STATE_UNSPECIFIED) select.Bind(filter.state);
  if (filter.owner.has_value() && !filter.owner->empty()) select.Bind(*filter.owner);
  select.Bind(filter.limit);
  return ReadRows<v1::Job>(std::move(select), [this](const Statement& row) { return Read(row); });
}

absl::StatusOr<std::vector<std::string>> JobTable::IdsOf(const std::string& batch_id, v1::JobState state, int limit) {
  return database_.Texts(
      "SELECT id FROM jobs WHERE batch_id != '' AND batch_id = ? AND state = ? ORDER BY failure_kind, id LIMIT ?",
      batch_id, state, limit);
}

absl::StatusOr<int64_t> JobTable::CountQueued() {
  return database_.FirstInt("SELECT count(*) FROM jobs WHERE state = 1");
}

absl::StatusOr<int64_t> JobTable::CountOpen(const std::string& caller) {
  return database_.FirstInt("SELECT count(*) FROM jobs WHERE state IN (1, 2) AND caller != '' AND caller = ?", caller);
}

absl::StatusOr<bool> JobTable::OwnsArtifact(const std::string& caller, const std::string& artifact_id) {
  return database_.Exists(
      "SELECT 1 FROM job_artifacts JOIN jobs ON jobs.id = job_id WHERE artifact_id = ? AND caller = ? LIMIT 1",
      artifact_id, caller);
}

absl::StatusOr<std::string> JobTable::OldestWaiting(const std::string& batch_id, absl::Time now) {
  return database_.FirstText(
      "SELECT id FROM jobs WHERE state = 1 AND batch_id = ? AND not_before_us <= ? ORDER BY id LIMIT 1", batch_id,
      absl::ToUnixMicros(now));
}

absl::StatusOr<std::string> JobTable::NextBatchWaiting(const std::string& after) {
  return database_.FirstText("SELECT batch_id FROM jobs WHERE state = 1 AND batch_id > ? ORDER BY batch_id LIMIT 1",
                             after);
}

absl::StatusOr<bool> JobTable::AnyDelayPassed(absl::Time now) {
  return database_.Exists("SELECT 1 FROM jobs WHERE state = 1 AND not_before_us > 0 AND not_before_us <= ? LIMIT 1",
                          absl::ToUnixMicros(now));
}

absl::StatusOr<bool> JobTable::Claim(const std::string& id, const std::string& owner) {
  return ChangesOne(
      "UPDATE jobs SET state = 2, owner = ?, attempt_count = attempt_count + 1, not_before_us = 0, "
      "lost_run_count = lost_run_count + 1, "
      "deletions_seen = (SELECT coalesce(max(seq), 0) FROM sqlite_sequence WHERE name = 'deleted_artifacts') "
      "WHERE id = ? AND state = 1",
      owner, id);
}

absl::StatusOr<std::vector<std::string>> JobTable::Owners() {
  return database_.Texts("SELECT DISTINCT owner FROM jobs WHERE state = 2 ORDER BY owner");
}

absl::Status JobTable::Release(const std::string& owner) {
  return database_.Run("UPDATE jobs SET state = 1, owner = '' WHERE state = 2 AND owner = ?", owner);
}

absl::StatusOr<int64_t> JobTable::LostRunCount(const std::string& id) {
  return database_.FirstInt("SELECT lost_run_count - (state = 2) FROM jobs WHERE id = ?", id);
}

absl::StatusOr<bool> JobTable::SetStage(const JobHold& hold, const std::string& stage, bool made_something) {
  // 1: this run, which counts as lost until it says otherwise.
  return ChangesOne("UPDATE jobs SET stage = ?, lost_run_count = iif(?, 1, lost_run_count)" IF_HELD, stage,
                    made_something, hold.job_id, hold.owner, hold.attempt);
}

absl::StatusOr<bool> JobTable::Requeue(const JobHold& hold, absl::Time not_before) {
  const int64_t not_before_us = not_before == absl::InfinitePast() ? 0 : absl::ToUnixMicros(not_before);
  return ChangesOne(
      "UPDATE jobs SET state = 1, owner = '', lost_run_count = lost_run_count - 1, not_before_us = ?" IF_HELD,
      not_before_us, hold.job_id, hold.owner, hold.attempt);
}

absl::StatusOr<bool> JobTable::End(const JobHold& hold, const v1::Job& job) {
  return ChangesOne(
      "UPDATE jobs SET state = ?, stage = ?, error = ?, error_code = ?, failure_kind = ?, end_time_us = ?, "
      "owner = ''" IF_HELD,
      job.state(), job.stage(), job.error(), job.error_code(), job.failure_kind(),
      TimeUtil::TimestampToMicroseconds(job.end_time()), hold.job_id, hold.owner, hold.attempt);
}

absl::StatusOr<bool> JobTable::CancelWaiting(const std::string& id, absl::Time time) {
  return ChangesOne("UPDATE jobs SET state = 5, cancel_requested = 1, end_time_us = ? WHERE id = ? AND state = 1",
                    absl::ToUnixMicros(time), id);
}

absl::StatusOr<bool> JobTable::Retry(const std::string& id) {
  return ChangesOne(
      "UPDATE jobs SET state = 1, error = '', error_code = 0, failure_kind = 0, end_time_us = 0, not_before_us = 0, "
      "cancel_requested = 0, lost_run_count = 0 WHERE id = ? AND state = 4",
      id);
}

absl::Status JobTable::RequestCancel(const std::string& id) {
  return database_.Run("UPDATE jobs SET cancel_requested = 1 WHERE id = ?", id);
}

absl::Status JobTable::RequestCancelOfBatch(const std::string& batch_id) {
  return database_.Run("UPDATE jobs SET cancel_requested = 1 WHERE batch_id != '' AND batch_id = ? AND state = 2",
                       batch_id);
}

absl::StatusOr<bool> JobTable::CancelRequested(const std::string& id) {
  return database_.Exists("SELECT 1 FROM jobs WHERE id = ? AND cancel_requested != 0", id);
}

absl::StatusOr<v1::Job> JobTable::Read(const Statement& row) {
  v1::Job job;
  job.set_id(row.Text(0));
  if (!job.mutable_spec()->ParseFromString(row.Text(1))) {
    return absl::DataLossError(fmt::format("job store: the spec of job {} is damaged", job.id()));
  }
  job.set_state(static_cast<v1::JobState>(row.Int(2)));
  job.set_stage(row.Text(3));
  job.set_error(row.Text(4));
  job.set_error_code(static_cast<int>(row.Int(5)));
  *job.mutable_create_time() = TimeUtil::MicrosecondsToTimestamp(row.Int(6));
  if (row.Int(7) != 0) *job.mutable_end_time() = TimeUtil::MicrosecondsToTimestamp(row.Int(7));
  job.set_batch_id(row.Text(8));
  job.set_batch_index(row.Int(9));
  job.set_failure_kind(static_cast<v1::FailureKind>(row.Int(10)));
  job.set_attempt_count(static_cast<int>(row.Int(11)));
  job.set_owner(row.Text(12));
  ASSIGN_OR_RETURN(const std::vector<v1::ArtifactRef> artifacts, ArtifactsOf(job.id()));
  job.mutable_artifacts()->Assign(artifacts.begin(), artifacts.end());
  return job;
}

absl::Status JobTable::AppendEvent(v1::JobEvent event) {
  const auto lock = database_.lock();
  ASSIGN_OR_RETURN(const int64_t last,
                   database_.FirstInt("SELECT max(sequence) FROM events WHERE job_id = ?", event.job_id()));
  event.set_sequence(last + 1);
  return database_.Run("INSERT INTO events VALUES (?, ?, ?)", event.job_id(), event.sequence(),
                       Blob{runtime::CanonicalBytes(event)});
}

absl::StatusOr<std::vector<v1::JobEvent>> JobTable::EventsAfter(const std::string& job_id, int64_t sequence,
                                                                int limit) {
  const auto lock = database_.lock();
  const auto read = [&job_id](const Statement& row) -> absl::StatusOr<v1::JobEvent> {
    v1::JobEvent event;
    if (event.ParseFromString(row.Text(0))) return event;
    return absl::DataLossError(fmt::format("job store: an event of job {} is damaged", job_id));
  };
  return ReadRows<v1::JobEvent>(
      database_.Prepare("SELECT event FROM events WHERE job_id = ? AND sequence > ? ORDER BY sequence LIMIT ?", job_id,
                        sequence, limit),
      read);
}

absl::StatusOr<std::vector<v1::ArtifactRef>> JobTable::ArtifactsOf(const std::string& job_id) {
  const auto lock = database_.lock();
  return ReadRows<v1::ArtifactRef>(
      database_.Prepare("SELECT artifact_id, kind, size_bytes FROM job_artifacts WHERE job_id = ? ORDER BY stage_index",
                        job_id),
      ReadRef);
}

absl::Status JobTable::Attach(const std::string& job_id, int stage_index, const v1::ArtifactRef& artifact) {
  return database_.Run("INSERT OR REPLACE INTO job_artifacts VALUES (?, ?, ?, ?, ?)", job_id, stage_index,
                       artifact.id(), artifact.kind(), artifact.size_bytes());
}

absl::StatusOr<std::optional<v1::ArtifactRef>> JobTable::FindResult(const std::string& key) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT artifact_id, kind, size_bytes FROM results WHERE key = ?", key);
  ASSIGN_OR_RETURN(const bool found, select.Step());
  if (!found) return std::nullopt;
  return ReadRef(select);
}

absl::Status JobTable::SetResult(const std::string& key, const v1::ArtifactRef& artifact) {
  return database_.Run("INSERT OR REPLACE INTO results VALUES (?, ?, ?, ?)", key, artifact.id(), artifact.kind(),
                       artifact.size_bytes());
}

}  // namespace flair::orchestrator
