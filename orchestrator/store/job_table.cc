// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/job_table.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include "orchestrator/store/artifact_table.h"
#include "worker_runtime/files/sha256.h"

namespace flair::orchestrator {
namespace {

using google::protobuf::util::TimeUtil;

// The columns that Read reads, in its order.
#define JOB_COLUMNS "id, spec, state, stage, error, error_code, create_time_us, end_time_us, batch_id"

}  // namespace

absl::Status JobTable::Insert(const v1::Job& job, const std::string& request_id) {
  const auto lock = database_.lock();
  Statement insert = database_.Prepare(
      "INSERT INTO jobs (id, request_id, spec, state, create_time_us, batch_id) VALUES (?, ?, ?, ?, ?, ?)");
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
  absl::StatusOr<bool> row = select.Bind(request_id).Step();
  if (!row.ok()) return row.status();
  return *row ? select.Text(0) : "";
}

absl::StatusOr<std::vector<v1::Job>> JobTable::List(int limit, const std::string& before, const std::string& batch_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      batch_id.empty()
          ? "SELECT " JOB_COLUMNS " FROM jobs WHERE ?1 = '' OR id < ?1 ORDER BY id DESC LIMIT ?2"
          : "SELECT " JOB_COLUMNS
            " FROM jobs WHERE (?1 = '' OR id < ?1) AND batch_id != '' AND batch_id = ?3 ORDER BY id DESC LIMIT ?2");
  select.Bind(before).Bind(limit);
  if (!batch_id.empty()) select.Bind(batch_id);
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

absl::StatusOr<int64_t> JobTable::CountQueued() {
  const auto lock = database_.lock();
  Statement count = database_.Prepare("SELECT count(*) FROM jobs WHERE state = 1");
  absl::StatusOr<bool> row = count.Step();
  if (!row.ok()) return row.status();
  return count.Int(0);
}

absl::StatusOr<std::optional<std::string>> JobTable::ClaimOldest(const std::string& owner) {
  const auto lock = database_.lock();
  Statement update = database_.Prepare(
      "UPDATE jobs SET state = 2, owner = ? WHERE id = (SELECT id FROM jobs WHERE state = 1 ORDER BY id LIMIT 1) "
      "RETURNING id");
  absl::StatusOr<bool> row = update.Bind(owner).Step();
  if (!row.ok()) return row.status();
  if (!*row) return std::nullopt;
  std::string id = update.Text(0);
  if (absl::Status status = update.Run(); !status.ok()) return status;
  return id;
}

absl::StatusOr<bool> JobTable::Claim(const std::string& id, const std::string& owner) {
  const auto lock = database_.lock();
  Statement update = database_.Prepare("UPDATE jobs SET state = 2, owner = ? WHERE id = ? AND state = 1");
  if (absl::Status status = update.Bind(owner).Bind(id).Run(); !status.ok()) return status;
  return database_.changes() == 1;
}

absl::StatusOr<std::vector<std::string>> JobTable::Owners() {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT DISTINCT owner FROM jobs WHERE state = 2 ORDER BY owner");
  std::vector<std::string> owners;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return owners;
    owners.push_back(select.Text(0));
  }
}

absl::Status JobTable::Release(const std::string& owner) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET state = 1, owner = '' WHERE state = 2 AND owner = ?").Bind(owner).Run();
}

absl::Status JobTable::ReleaseOne(const std::string& id) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET state = 1, owner = '' WHERE state = 2 AND id = ?").Bind(id).Run();
}

absl::Status JobTable::SetStage(const std::string& id, const std::string& stage) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET stage = ? WHERE id = ?").Bind(stage).Bind(id).Run();
}

absl::Status JobTable::End(const v1::Job& job) {
  const auto lock = database_.lock();
  return database_
      .Prepare(
          "UPDATE jobs SET state = ?, stage = ?, error = ?, error_code = ?, end_time_us = ?, owner = '' WHERE id = ?")
      .Bind(job.state())
      .Bind(job.stage())
      .Bind(job.error())
      .Bind(job.error_code())
      .Bind(TimeUtil::TimestampToMicroseconds(job.end_time()))
      .Bind(job.id())
      .Run();
}

absl::Status JobTable::RequestCancel(const std::string& id) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE jobs SET cancel_requested = 1 WHERE id = ?").Bind(id).Run();
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
  absl::StatusOr<std::vector<v1::ArtifactRef>> artifacts = ArtifactTable(database_).OfJob(job.id());
  if (!artifacts.ok()) return artifacts.status();
  job.mutable_artifacts()->Assign(artifacts->begin(), artifacts->end());
  return job;
}

}  // namespace flair::orchestrator
