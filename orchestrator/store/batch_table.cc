// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/batch_table.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>

namespace flair::orchestrator {
namespace {

using google::protobuf::util::TimeUtil;

// The columns that ReadBatch reads, in its order.
#define BATCH_COLUMNS "id, job_count, state, open, label, create_time_us, caller"

v1::Batch ReadBatch(const Statement& row) {
  v1::Batch batch;
  batch.set_id(row.Text(0));
  batch.set_job_count(static_cast<int>(row.Int(1)));
  batch.set_state(static_cast<v1::BatchState>(row.Int(2)));
  batch.set_open(row.Int(3) != 0);
  batch.set_label(row.Text(4));
  *batch.mutable_create_time() = TimeUtil::MicrosecondsToTimestamp(row.Int(5));
  batch.set_owner(row.Text(6));
  return batch;
}

void AddCount(v1::JobState state, v1::FailureKind kind, int jobs, v1::Batch& batch) {
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

}  // namespace

absl::Status BatchTable::Insert(const store::v1::BatchRecord& record) {
  const auto lock = database_.lock();
  const v1::Batch& batch = record.batch();
  return database_
      .Prepare(
          "INSERT INTO batches (id, request_id, specs_digest, state, open, label, create_time_us, caller) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
      .Bind(batch.id())
      .Bind(record.request_id())
      .Bind(record.specs_digest())
      .Bind(batch.state())
      .Bind(batch.open())
      .Bind(batch.label())
      .Bind(TimeUtil::TimestampToMicroseconds(batch.create_time()))
      .Bind(batch.owner())
      .Run();
}

absl::StatusOr<std::optional<store::v1::BatchRecord>> BatchTable::FindByRequest(const std::string& request_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT " BATCH_COLUMNS ", specs_digest FROM batches WHERE request_id = ?");
  absl::StatusOr<bool> row = select.Bind(request_id).Step();
  if (!row.ok()) return row.status();
  if (!*row) return std::nullopt;
  store::v1::BatchRecord record;
  *record.mutable_batch() = ReadBatch(select);
  record.set_request_id(request_id);
  record.set_specs_digest(select.Text(7));
  return record;
}

absl::StatusOr<v1::Batch> BatchTable::Get(const std::string& id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT " BATCH_COLUMNS " FROM batches WHERE id = ?");
  absl::StatusOr<bool> row = select.Bind(id).Step();
  if (!row.ok()) return row.status();
  if (!*row) return absl::NotFoundError(fmt::format("batch_id: no batch \"{}\" in this store", id.substr(0, 80)));
  return ReadBatch(select);
}

absl::StatusOr<v1::Batch> BatchTable::GetWithCounts(const std::string& id) {
  const auto lock = database_.lock();
  absl::StatusOr<v1::Batch> batch = Get(id);
  if (!batch.ok()) return batch;
  Statement count = database_.Prepare(
      "SELECT state, failure_kind, count(*) FROM jobs WHERE batch_id != '' AND batch_id = ? "
      "GROUP BY state, failure_kind");
  count.Bind(id);
  while (true) {
    absl::StatusOr<bool> row = count.Step();
    if (!row.ok()) return row.status();
    if (!*row) break;
    AddCount(static_cast<v1::JobState>(count.Int(0)), static_cast<v1::FailureKind>(count.Int(1)),
             static_cast<int>(count.Int(2)), *batch);
  }
  std::ranges::stable_sort(*batch->mutable_failures(), std::greater(), &v1::FailureCount::job_count);
  return batch;
}

absl::StatusOr<std::vector<v1::Batch>> BatchTable::List(const ListFilter& filter) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT " BATCH_COLUMNS
      " FROM batches WHERE (?1 = '' OR id < ?1) AND (?2 = 0 OR caller = ?3) ORDER BY id DESC LIMIT ?4");
  select.Bind(filter.before).Bind(filter.owner.has_value()).Bind(filter.owner.value_or("")).Bind(filter.limit);
  std::vector<v1::Batch> batches;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return batches;
    batches.push_back(ReadBatch(select));
  }
}

absl::Status BatchTable::SetState(const std::string& id, v1::BatchState state) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE batches SET state = ? WHERE id = ?").Bind(state).Bind(id).Run();
}

absl::Status BatchTable::SetJobs(const std::string& id, int64_t job_count, bool open) {
  const auto lock = database_.lock();
  return database_.Prepare("UPDATE batches SET job_count = ?, open = ? WHERE id = ?")
      .Bind(job_count)
      .Bind(open)
      .Bind(id)
      .Run();
}

absl::Status BatchTable::AddEnd(const std::string& batch_id, const std::string& job_id) {
  const auto lock = database_.lock();
  if (absl::Status status = RemoveEnd(job_id); !status.ok()) return status;
  return database_.Prepare("INSERT INTO ends (batch_id, job_id) VALUES (?, ?)").Bind(batch_id).Bind(job_id).Run();
}

absl::Status BatchTable::RemoveEnd(const std::string& job_id) {
  const auto lock = database_.lock();
  return database_.Prepare("DELETE FROM ends WHERE job_id = ?").Bind(job_id).Run();
}

absl::StatusOr<std::vector<BatchEnd>> BatchTable::EndsAfter(const std::string& batch_id, int64_t sequence, int limit) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare(
      "SELECT sequence, job_id FROM ends WHERE batch_id = ? AND sequence > ? ORDER BY sequence LIMIT ?");
  select.Bind(batch_id).Bind(sequence).Bind(limit);
  std::vector<BatchEnd> ends;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return ends;
    ends.push_back({select.Int(0), select.Text(1)});
  }
}

}  // namespace flair::orchestrator
