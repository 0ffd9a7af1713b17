// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/sqlite_lease.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <utility>

#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

SqliteLease::SqliteLease(SqliteWorkQueue& queue, v1::Job job, std::vector<v1::JobEvent> history, int lost_run_count,
                         std::shared_ptr<runtime::Cancellation> cancellation)
    : queue_(queue),
      store_(*queue.store_),
      job_(std::move(job)),
      history_(std::move(history)),
      lost_run_count_(lost_run_count),
      cancellation_(std::move(cancellation)),
      hold_{job_.id(), store_.owner(), job_.attempt_count()} {}

SqliteLease::~SqliteLease() {
  if (!done_ && !lost_) (void)Return(absl::ZeroDuration(), "");
  queue_.Forget(job_.id());
}

absl::Status SqliteLease::CheckHeld(const absl::StatusOr<bool>& changed) {
  if (!changed.ok()) return changed.status();
  if (*changed) return absl::OkStatus();
  lost_ = true;
  return absl::AbortedError(fmt::format("job {}: another run has it", job_.id()));
}

absl::Status SqliteLease::Append(std::span<const StageRecord> records) {
  if (records.empty()) return absl::OkStatus();
  RETURN_IF_ERROR(CheckNotDeleted(records));
  for (const StageRecord& record : records) {
    const v1::ArtifactRef& artifact = record.event.artifact();
    RETURN_IF_ERROR(store_.jobs().AppendEvent(record.event));
    if (record.event.has_artifact()) {
      RETURN_IF_ERROR(store_.jobs().Attach(job_.id(), record.stage_index, artifact));
    }
    if (!record.result_key.empty()) RETURN_IF_ERROR(store_.jobs().SetResult(record.result_key, artifact));
  }
  return absl::OkStatus();
}

absl::Status SqliteLease::CheckNotDeleted(std::span<const StageRecord> records) {
  ASSIGN_OR_RETURN(const bool any, store_.deletions().Any());
  if (!any) return absl::OkStatus();
  for (const StageRecord& record : records) {
    if (!record.event.has_artifact()) continue;
    const std::string& id = record.event.artifact().id();
    ASSIGN_OR_RETURN(const bool deleted, store_.deletions().WasDeleted(id, job_.id()));
    if (deleted) return ArtifactIsGone(id);
  }
  return absl::OkStatus();
}

void SqliteLease::SettleDeletions(std::span<const StageRecord> records) {
  for (const StageRecord& record : records) {
    const std::string& id = record.event.artifact().id();
    const absl::StatusOr<bool> deleted = store_.deletions().WasDeleted(id, job_.id());
    if (deleted.ok() && *deleted) (void)store_.deletions().SetDeleted(id);
  }
}

absl::Status SqliteLease::Write(Transaction::Durability durability, std::span<const StageRecord> records,
                                const std::function<absl::Status()>& change) {
  absl::Status status;
  {
    ASSIGN_OR_RETURN(auto transaction, Transaction::Begin(store_.database(), durability));
    status = change();
    if (status.ok()) status = transaction.Commit();
  }
  if (IsArtifactGone(status)) SettleDeletions(records);
  return status;
}

absl::Status SqliteLease::RecordAll(std::span<const StageRecord> records) {
  if (records.empty()) return absl::OkStatus();
  RETURN_IF_ERROR(Write(Transaction::Durability::kProcessCrash, records, [&]() -> absl::Status {
    const bool made_something = std::ranges::any_of(records, [](const auto& it) { return it.event.has_artifact(); });
    RETURN_IF_ERROR(CheckHeld(store_.jobs().SetStage(hold_, records.back().event.stage(), made_something)));
    return Append(records);
  }));
  queue_.NotifyChanged(job_.id());
  return absl::OkStatus();
}

absl::Status SqliteLease::End(const JobEnd& end) {
  v1::Job job = job_;
  job.set_state(end.state);
  job.set_stage(end.stage);
  job.set_error(std::string(end.error.message()));
  job.set_error_code(static_cast<int>(end.error.code()));
  job.set_failure_kind(end.failure_kind);
  *job.mutable_end_time() = google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(end.time));
  RETURN_IF_ERROR(Write(Transaction::Durability::kPowerLoss, end.records, [&]() -> absl::Status {
    RETURN_IF_ERROR(CheckHeld(store_.jobs().End(hold_, job)));
    RETURN_IF_ERROR(Append(end.records));
    return queue_.AppendEnded(job);
  }));
  done_ = true;
  queue_.NotifyChanged(job_.id());
  if (!job_.batch_id().empty()) queue_.NotifyBatchChanged(job_.batch_id());
  return absl::OkStatus();
}

absl::Status SqliteLease::Return(absl::Duration delay, const std::string& reason) {
  const absl::Time not_before = delay > absl::ZeroDuration() ? queue_.clock_.Now() + delay : absl::InfinitePast();
  RETURN_IF_ERROR(Write(Transaction::Durability::kProcessCrash, {}, [&] {
    absl::Status held = CheckHeld(store_.jobs().Requeue(hold_, not_before));
    if (!held.ok() || reason.empty()) return held;
    v1::JobEvent event;
    event.set_job_id(job_.id());
    event.set_kind(v1::JOB_EVENT_KIND_WAITING);
    event.set_message(reason);
    event.set_state(v1::JOB_STATE_QUEUED);
    return store_.jobs().AppendEvent(event);
  }));
  done_ = true;
  queue_.NotifyChanged(job_.id());
  queue_.NotifyWork();
  return absl::OkStatus();
}

bool SqliteLease::cancel_requested() {
  const absl::StatusOr<bool> requested = store_.jobs().CancelRequested(job_.id());
  return requested.ok() && *requested;
}

}  // namespace flair::orchestrator
