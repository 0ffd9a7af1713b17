// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/job_table.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include "orchestrator/store/artifact_table.h"
#include "orchestrator/store/digest_functions.h"
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

Statement& BindHold(Statement& statement, const JobHold& hold) {
  return statement.Bind(hold.job_id).Bind(hold.owner).Bind(hold.attempt);
}

}  // namespace

absl::Status JobTable::Insert(const v1::Job& job, const std::string& request_id) {
  const auto lock = database_.lock();
  Statement insert = database_.Prepare(
      "INSERT INTO jobs (id, request_id, spec, state, create_time_us, batch_id, batch_index, caller) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  insert.Bind(job.id());
  if (request_id.empty()) {
    insert.BindNull();
  } else {
    insert.Bind(request_id);
  }
  return insert.BindBytes(runtime::CanonicalBytes(job.spec()))
      .Bind(v1::JOB_STATE_QUEUED)
      .Bind(TimeUtil::TimestampToMicroseconds(job.create_time()))
      .Bind(job.batch_id())
      .Bind(job.batch_index())
      .Bind(job.owner())
      .Run();
}

absl::StatusOr<v1::Job> JobTable::Get(const std::string& id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT " JOB_COLUMNS " FROM jobs WHERE id = ?");
  absl::StatusOr<bool> row = select.Bind(id).Step();
  if (!row.ok()) return row.status();
  if (!*row) return absl::NotFoundError(fmt::format("job_id: no job \"{}\" in this store", id.substr(0, 80)));
  return Read(select);
}

absl::StatusOr<std::string> JobTable::FindByRequest(const std::string& request_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT id FROM jobs WHERE request_id = ?");
  return First(select.Bind(request_id));
}

absl::StatusOr<std::vector<v1::Job>> JobTable::List(const ListFilter& filter) {
  const auto lock = database_.lock();
  // Conditions that are not asked for are left out, so that each form of the question finds its index.
  std::string sql = "SELECT " JOB_COLUMNS " FROM jobs WHERE (?1 = '' OR id < ?1)";
  if (!filter.batch_id.empty()) sql += " AND batch_id != '' AND batch_id = ?3";
  if (filter.state != v1::JOB_STATE_UNSPECIFIED) sql += " AND state = ?4";
  if (filter.owner.has_value()) sql += filter.owner->empty() ? " AND caller = ''" : " AND caller != '' AND caller = ?5";
  Statement select = database_.Prepare(sql + " ORDER BY id DESC LIMIT ?2");
  select.BindAt(1, filter.before).BindAt(2, filter.limit);
  if (!filter.batch_id.empty()) select.BindAt(3, filter.batch_id);
  if (filter.state != v1::JOB_STATE_UNSPECIFIED) select.BindAt(4, filter.state);
  if (filter.owner.has_value() && !filter.owner->empty()) select.BindAt(5, *filter.owner);
  std::vector<v1::Job> jobs;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return jobs;
    absl::StatusOr<v1::Job> job = Read(select);
    if (!job.ok()) return job.status();
    jobs.push_back(*std::move(job));
  }
}

absl::StatusOr<std::vector<std::string>> JobTable::IdsOf(const std::string& batch_id, v1::JobState state, int limit) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT id FROM jobs WHERE batch_id != '' AND batch_id = ? AND state = ? ORDER BY failure_kind, id LIMIT ?");
  select.Bind(batch_id).Bind(state).Bind(limit);
  return select.Texts();
}

absl::StatusOr<int64_t> JobTable::CountQueued() {
  const auto lock = database_.lock();
  Statement count = database_.Prepare("SELECT count(*) FROM jobs WHERE state = 1");
  return Number(count);
}

absl::StatusOr<int64_t> JobTable::CountOpen(const std::string& caller) {
  const auto lock = database_.lock();
  Statement count =
      database_.Prepare("SELECT count(*) FROM jobs WHERE state IN (1, 2) AND caller != '' AND caller = ?");
  return Number(count.Bind(caller));
}

absl::StatusOr<bool> JobTable::OwnsArtifact(const std::string& caller, const std::string& artifact_id) {
  const auto lock = database_.lock();
  Statement select =
      database_.Prepare("SELECT 1 FROM job_artifacts WHERE artifact_id = ? AND caller != '' AND caller = ? LIMIT 1");
  return select.BindBytes(DigestBytes(artifact_id)).Bind(caller).Step();
}

absl::StatusOr<std::string> JobTable::OldestWaiting(const std::string& batch_id, absl::Time now) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT id FROM jobs WHERE state = 1 AND batch_id = ? AND not_before_us <= ? ORDER BY id LIMIT 1");
  return First(select.Bind(batch_id).Bind(absl::ToUnixMicros(now)));
}

absl::StatusOr<std::string> JobTable::NextBatchWaiting(const std::string& after) {
  const auto lock = database_.lock();
  Statement select =
      database_.Prepare("SELECT batch_id FROM jobs WHERE state = 1 AND batch_id > ? ORDER BY batch_id LIMIT 1");
  return First(select.Bind(after));
}

absl::StatusOr<bool> JobTable::AnyDelayPassed(absl::Time now) {
  const auto lock = database_.lock();
  Statement select =
      database_.Prepare("SELECT 1 FROM jobs WHERE state = 1 AND not_before_us > 0 AND not_before_us <= ? LIMIT 1");
  return select.Bind(absl::ToUnixMicros(now)).Step();
}

absl::StatusOr<bool> JobTable::Claim(const std::string& id, const std::string& owner) {
  const auto lock = database_.lock();
  Statement update = database_.Prepare(
      "UPDATE jobs SET state = 2, owner = ?, attempt_count = attempt_count + 1, not_before_us = 0, "
      "lost_run_count = lost_run_count + 1, "
      "deletions_seen = (SELECT coalesce(max(seq), 0) FROM sqlite_sequence WHERE name = 'deleted_artifacts') "
      "WHERE id = ? AND state = 1");
  return ChangesOne(update.Bind(owner).Bind(id));
}

absl::StatusOr<std::vector<std::string>> JobTable::Owners() {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT DISTINCT owner FROM jobs WHERE state = 2 ORDER BY owner");
  return select.Texts();
}

absl::Status JobTable::Release(const std::string& owner) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET state = 1, owner = '' WHERE state = 2 AND owner = ?").Bind(owner).Run();
}

absl::StatusOr<int> JobTable::LostRunCount(const std::string& id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT lost_run_count - (state = 2) FROM jobs WHERE id = ?");
  const absl::StatusOr<int64_t> count = Number(select.Bind(id));
  if (!count.ok()) return count.status();
  return static_cast<int>(*count);
}

absl::StatusOr<bool> JobTable::SetStage(const JobHold& hold, const std::string& stage, bool made_something) {
  const auto lock = database_.lock();
  // 1: this run, which is counted as lost until it says otherwise.
  Statement update = database_.Prepare("UPDATE jobs SET stage = ?, lost_run_count = iif(?, 1, lost_run_count)" IF_HELD);
  return ChangesOne(BindHold(update.Bind(stage).Bind(int64_t{made_something}), hold));
}

absl::StatusOr<bool> JobTable::Requeue(const JobHold& hold, absl::Time not_before) {
  const auto lock = database_.lock();
  Statement update = database_.Prepare(
      "UPDATE jobs SET state = 1, owner = '', lost_run_count = lost_run_count - 1, not_before_us = ?" IF_HELD);
  const int64_t not_before_us = not_before == absl::InfinitePast() ? 0 : absl::ToUnixMicros(not_before);
  return ChangesOne(BindHold(update.Bind(not_before_us), hold));
}

absl::StatusOr<bool> JobTable::End(const JobHold& hold, const v1::Job& job) {
  const auto lock = database_.lock();
  Statement update = database_.Prepare(
      "UPDATE jobs SET state = ?, stage = ?, error = ?, error_code = ?, failure_kind = ?, end_time_us = ?, owner = "
      "''" IF_HELD);
  update.Bind(job.state()).Bind(job.stage()).Bind(job.error()).Bind(job.error_code()).Bind(job.failure_kind());
  return ChangesOne(BindHold(update.Bind(TimeUtil::TimestampToMicroseconds(job.end_time())), hold));
}

absl::StatusOr<bool> JobTable::CancelWaiting(const std::string& id, absl::Time time) {
  const auto lock = database_.lock();
  Statement update =
      database_.Prepare("UPDATE jobs SET state = 5, cancel_requested = 1, end_time_us = ? WHERE id = ? AND state = 1");
  return ChangesOne(update.Bind(absl::ToUnixMicros(time)).Bind(id));
}

absl::StatusOr<bool> JobTable::Retry(const std::string& id) {
  const auto lock = database_.lock();
  Statement update = database_.Prepare(
      "UPDATE jobs SET state = 1, error = '', error_code = 0, failure_kind = 0, end_time_us = 0, not_before_us = 0, "
      "cancel_requested = 0, lost_run_count = 0 WHERE id = ? AND state = 4");
  return ChangesOne(update.Bind(id));
}

absl::Status JobTable::RequestCancel(const std::string& id) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET cancel_requested = 1 WHERE id = ?").Bind(id).Run();
}

absl::Status JobTable::RequestCancelOfBatch(const std::string& batch_id) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET cancel_requested = 1 WHERE batch_id != '' AND batch_id = ? AND state = 2")
      .Bind(batch_id)
      .Run();
}

absl::StatusOr<bool> JobTable::CancelRequested(const std::string& id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT cancel_requested FROM jobs WHERE id = ?");
  absl::StatusOr<bool> row = select.Bind(id).Step();
  if (!row.ok()) return row.status();
  return *row && select.Int(0) != 0;
}

absl::StatusOr<v1::Job> JobTable::Read(Statement& row) {
  v1::Job job;
  job.set_id(row.Text(0));
  if (!job.mutable_spec()->ParseFromString(row.Bytes(1))) {
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
  absl::StatusOr<std::vector<v1::ArtifactRef>> artifacts = ArtifactTable(database_).OfJob(job.id());
  if (!artifacts.ok()) return artifacts.status();
  job.mutable_artifacts()->Assign(artifacts->begin(), artifacts->end());
  return job;
}

absl::StatusOr<std::string> JobTable::First(Statement& select) {
  absl::StatusOr<bool> row = select.Step();
  if (!row.ok()) return row.status();
  return *row ? select.Text(0) : "";
}

absl::StatusOr<int64_t> JobTable::Number(Statement& select) {
  absl::StatusOr<bool> row = select.Step();
  if (!row.ok()) return row.status();
  return select.Int(0);
}

absl::StatusOr<bool> JobTable::ChangesOne(Statement& update) {
  if (absl::Status status = update.Run(); !status.ok()) return status;
  return database_.changes() == 1;
}

}  // namespace flair::orchestrator
