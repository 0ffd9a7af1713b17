// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/sqlite_lease.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <utility>

namespace flair::orchestrator {

SqliteLease::SqliteLease(SqliteWorkQueue& queue, v1::Job job, std::vector<v1::JobEvent> history, int lost_run_count,
                         std::shared_ptr<runtime::Cancellation> cancellation)
    : queue_(queue),
      store_(*queue.store_),
      job_(std::move(job)),
      history_(std::move(history)),
      lost_run_count_(lost_run_count),
      cancellation_(std::move(cancellation)),
      hold_{job_.id(), store_.owner(), job_.attempt_count()},
      holder_(job_) {}

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
  absl::Status status = CheckNotDeleted(records);
  if (!status.ok()) return status;
  const absl::StatusOr<int64_t> last = store_.events().LastSequence(job_.id());
  if (!last.ok()) return last.status();
  int64_t sequence = *last;
  for (const StageRecord& record : records) {
    v1::JobEvent event = record.event;
    event.set_sequence(++sequence);
    if (status.ok()) status = store_.events().Insert(event);
    if (status.ok() && event.has_artifact()) {
      status = store_.artifacts().Attach(holder_, record.stage_index, event.artifact());
    }
    if (status.ok() && !record.result_key.empty()) {
      status = store_.artifacts().SetResult(holder_.brief, record.result_key, event.artifact());
    }
  }
  return status;
}

absl::Status SqliteLease::CheckNotDeleted(std::span<const StageRecord> records) {
  const absl::StatusOr<bool> any = store_.deletions().Any();
  if (!any.ok() || !*any) return any.status();
  for (const StageRecord& record : records) {
    if (!record.event.has_artifact()) continue;
    const std::string& id = record.event.artifact().id();
    const absl::StatusOr<bool> deleted = store_.deletions().WasDeleted(id, job_.id());
    if (!deleted.ok()) return deleted.status();
    if (*deleted) return ArtifactIsGone(id);
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
    auto transaction = Transaction::Begin(store_.database(), durability);
    if (!transaction.ok()) return transaction.status();
    status = change();
    if (status.ok()) status = transaction->Commit();
  }
  if (IsArtifactGone(status)) SettleDeletions(records);
  if (status.ok() && !records.empty()) queue_.no_results_.Forget(holder_.brief);
  return status;
}

absl::Status SqliteLease::RecordAll(std::span<const StageRecord> records) {
  if (records.empty()) return absl::OkStatus();
  const absl::Status status = Write(Transaction::Durability::kProcessCrash, records, [&] {
    const bool made_something = std::ranges::any_of(records, [](const auto& it) { return it.event.has_artifact(); });
    absl::Status held = CheckHeld(store_.jobs().SetStage(hold_, records.back().event.stage(), made_something));
    return held.ok() ? Append(records) : held;
  });
  if (!status.ok()) return status;
  queue_.Tell(job_.id());
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
  const absl::Status status = Write(Transaction::Durability::kPowerLoss, end.records, [&] {
    absl::Status ended = CheckHeld(store_.jobs().End(hold_, job));
    if (ended.ok()) ended = Append(end.records);
    return ended.ok() ? queue_.AppendEnded(job) : ended;
  });
  if (!status.ok()) return status;
  done_ = true;
  queue_.Tell(job_.id());
  if (!job_.batch_id().empty()) queue_.TellOfBatch(job_.batch_id());
  return absl::OkStatus();
}

absl::Status SqliteLease::Return(absl::Duration delay, const std::string& reason) {
  const absl::Time not_before = delay > absl::ZeroDuration() ? queue_.clock_.Now() + delay : absl::InfinitePast();
  const absl::Status status = Write(Transaction::Durability::kProcessCrash, {}, [&] {
    absl::Status held = CheckHeld(store_.jobs().Requeue(hold_, not_before));
    if (!held.ok() || reason.empty()) return held;
    v1::JobEvent event;
    event.set_job_id(job_.id());
    event.set_kind(v1::JOB_EVENT_KIND_WAITING);
    event.set_message(reason);
    event.set_state(v1::JOB_STATE_QUEUED);
    return store_.events().Append(event);
  });
  if (!status.ok()) return status;
  done_ = true;
  queue_.Tell(job_.id());
  queue_.TellOfWork();
  return absl::OkStatus();
}

bool SqliteLease::cancel_requested() {
  const absl::StatusOr<bool> requested = store_.jobs().CancelRequested(job_.id());
  return requested.ok() && *requested;
}

}  // namespace flair::orchestrator
