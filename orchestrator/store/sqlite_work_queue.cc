// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/sqlite_work_queue.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "orchestrator/batch/lease.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

namespace {
// An orchestrator that has said nothing for so long is not counted any more.
constexpr absl::Duration kStatusLife = absl::Seconds(10);
}  // namespace

// A run of a job in a store. Every write asks in its own transaction whether the run still holds the job.
class SqliteLease final : public Lease {
 public:
  SqliteLease(SqliteWorkQueue& queue, v1::Job job, std::vector<v1::JobEvent> history, int lost_run_count,
              std::shared_ptr<runtime::Cancellation> cancellation)
      : queue_(queue),
        store_(*queue.store_),
        job_(std::move(job)),
        history_(std::move(history)),
        lost_run_count_(lost_run_count),
        cancellation_(std::move(cancellation)),
        hold_{job_.id(), store_.owner(), job_.attempt_count()} {}

  ~SqliteLease() override {
    if (!done_ && !lost_) (void)Return(absl::ZeroDuration(), "");
    queue_.Forget(job_.id());
  }

  const v1::Job& job() const override { return job_; }
  const std::vector<v1::JobEvent>& history() const override { return history_; }
  int lost_run_count() const override { return lost_run_count_; }
  // Nothing to do: RecordAll and deletions exclude each other.
  absl::Status Announce(std::span<const StageRecord>) override { return absl::OkStatus(); }

  absl::Status RecordAll(std::span<const StageRecord> records) override {
    if (records.empty()) return absl::OkStatus();
    RETURN_IF_ERROR(Write(Transaction::Durability::kProcessCrash, records, [&]() -> absl::Status {
      const bool made_something = std::ranges::any_of(records, [](const auto& it) { return it.event.has_artifact(); });
      RETURN_IF_ERROR(CheckHeld(store_.jobs().SetStage(hold_, records.back().event.stage(), made_something)));
      return Append(records);
    }));
    queue_.NotifyChanged(job_.id());
    return absl::OkStatus();
  }

  absl::Status End(const JobEnd& end) override {
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

  absl::Status Return(absl::Duration delay, const std::string& reason) override {
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

  runtime::Cancellation& cancellation() override { return *cancellation_; }

  bool cancel_requested() override {
    const absl::StatusOr<bool> requested = store_.jobs().CancelRequested(job_.id());
    return requested.ok() && *requested;
  }

  bool lost() override { return lost_; }

 private:
  // Makes a change in one transaction; when that fails since one of the artifacts was deleted, settles their deletions.
  absl::Status Write(Transaction::Durability durability, std::span<const StageRecord> records,
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

  // `changed`: whether the run still held the job. ABORTED when not.
  absl::Status CheckHeld(const absl::StatusOr<bool>& changed) {
    if (!changed.ok()) return changed.status();
    if (*changed) return absl::OkStatus();
    lost_ = true;
    return absl::AbortedError(fmt::format("job {}: another run has it", job_.id()));
  }

  // In a transaction of the caller's. ArtifactIsGone when one of the artifacts may have been deleted.
  absl::Status Append(std::span<const StageRecord> records) {
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

  absl::Status CheckNotDeleted(std::span<const StageRecord> records) {
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

  // Turns what waits for its deletion into what was deleted, so that the next run may store it.
  void SettleDeletions(std::span<const StageRecord> records) {
    for (const StageRecord& record : records) {
      const std::string& id = record.event.artifact().id();
      const absl::StatusOr<bool> deleted = store_.deletions().WasDeleted(id, job_.id());
      if (deleted.ok() && *deleted) (void)store_.deletions().SetDeleted(id);
    }
  }

  SqliteWorkQueue& queue_;
  JobStore& store_;
  const v1::Job job_;
  const std::vector<v1::JobEvent> history_;
  const int lost_run_count_;
  // Shared with the queue, which cancels it.
  const std::shared_ptr<runtime::Cancellation> cancellation_;
  const JobHold hold_;
  std::atomic<bool> lost_ = false;
  bool done_ = false;
};

absl::StatusOr<std::unique_ptr<WorkQueue>> SqliteWorkQueue::Open(const std::string& path, const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<JobStore> store, JobStore::Open(path));
  return std::unique_ptr<WorkQueue>(new SqliteWorkQueue(std::move(store), clock));
}

SqliteWorkQueue::SqliteWorkQueue(std::unique_ptr<JobStore> store, const runtime::Clock& clock)
    : store_(std::move(store)), clock_(clock) {
  monitor_ = std::make_unique<StoreMonitor>(*store_,
                                            StoreMonitor::Callbacks{[this] { OnChange(); }, [this] { OnOwnerGone(); }});
}

SqliteWorkQueue::~SqliteWorkQueue() { monitor_.reset(); }

absl::StatusOr<std::unique_ptr<Lease>> SqliteWorkQueue::Take(const TakeFilter& filter) {
  std::string id;
  v1::Job job;
  std::vector<v1::JobEvent> history;
  int64_t lost_run_count = 0;
  {
    ASSIGN_OR_RETURN(auto transaction, Transaction::Begin(store_->database()));
    ASSIGN_OR_RETURN(id, ChooseJob(filter));
    if (id.empty()) return nullptr;
    RETURN_IF_ERROR(store_->jobs().Claim(id, store_->owner()).status());
    ASSIGN_OR_RETURN(job, store_->jobs().Get(id));
    ASSIGN_OR_RETURN(history, store_->jobs().EventsAfter(id, 0, 10000));
    ASSIGN_OR_RETURN(lost_run_count, store_->jobs().LostRunCount(id));
    RETURN_IF_ERROR(transaction.Commit());
  }
  auto cancellation = std::make_shared<runtime::Cancellation>();
  {
    std::lock_guard lock(mutex_);
    held_[id] = cancellation;
    if (!job.batch_id().empty()) last_batch_ = job.batch_id();
  }
  auto lease = std::make_unique<SqliteLease>(*this, std::move(job), std::move(history),
                                             static_cast<int>(lost_run_count), cancellation);
  if (lease->cancel_requested()) cancellation->Cancel();
  return lease;
}

absl::StatusOr<std::string> SqliteWorkQueue::ChooseJob(const TakeFilter& filter) {
  const absl::Time now = clock_.Now();
  if (filter.any) {
    ASSIGN_OR_RETURN(std::string alone, store_->jobs().OldestWaiting("", now));
    return alone.empty() ? ChooseOfAnyBatch() : alone;
  }
  for (const std::string& id : filter.job_ids) {
    const absl::StatusOr<v1::Job> job = store_->jobs().Get(id);
    if (absl::IsNotFound(job.status())) continue;
    if (!job.ok()) return job.status();
    if (job->state() == v1::JOB_STATE_QUEUED) return id;
  }
  for (const std::string& batch_id : filter.batch_ids) {
    ASSIGN_OR_RETURN(const bool active, BatchIsActive(batch_id));
    if (!active) continue;
    ASSIGN_OR_RETURN(std::string id, store_->jobs().OldestWaiting(batch_id, now));
    if (!id.empty()) return id;
  }
  return "";
}

// The batches have turns, by id: the next one after the last that is active and has a job to run.
absl::StatusOr<std::string> SqliteWorkQueue::ChooseOfAnyBatch() {
  const absl::Time now = clock_.Now();
  std::string start;
  {
    std::lock_guard lock(mutex_);
    start = last_batch_;
  }
  std::string at = start;
  for (bool wrapped = false;;) {
    ASSIGN_OR_RETURN(std::string next, store_->jobs().NextBatchWaiting(at));
    if (next.empty() && !wrapped) {
      wrapped = true;
      at = "";
      continue;
    }
    if (next.empty() || (wrapped && next > start)) return "";
    at = std::move(next);
    ASSIGN_OR_RETURN(const bool active, BatchIsActive(at));
    if (!active) continue;
    ASSIGN_OR_RETURN(std::string id, store_->jobs().OldestWaiting(at, now));
    if (!id.empty()) return id;
  }
}

absl::StatusOr<bool> SqliteWorkQueue::BatchIsActive(const std::string& batch_id) {
  const absl::StatusOr<v1::Batch> batch = store_->batches().Get(batch_id);
  if (absl::IsNotFound(batch.status())) return false;
  if (!batch.ok()) return batch.status();
  return batch->state() == v1::BATCH_STATE_ACTIVE;
}

absl::StatusOr<bool> SqliteWorkQueue::BatchHasEnded(const std::string& batch_id) {
  ASSIGN_OR_RETURN(const v1::Batch batch, store_->batches().Get(batch_id));
  if (batch.open()) return false;
  for (const v1::JobState state : {v1::JOB_STATE_QUEUED, v1::JOB_STATE_RUNNING}) {
    ASSIGN_OR_RETURN(const auto ids, store_->jobs().IdsOf(batch_id, state, 1));
    if (!ids.empty()) return false;
  }
  return true;
}

absl::Status SqliteWorkQueue::ReportStatus(const v1::OrchestratorStatus& status) {
  Database& database = store_->database();
  const absl::Time now = clock_.Now();
  RETURN_IF_ERROR(
      database.Run("DELETE FROM orchestrators WHERE report_time_us < ?", absl::ToUnixMicros(now - kStatusLife)));
  return database.Run("INSERT OR REPLACE INTO orchestrators VALUES (?, ?, ?)", status.id(),
                      Blob{status.SerializeAsString()}, absl::ToUnixMicros(now));
}

absl::StatusOr<std::vector<v1::OrchestratorStatus>> SqliteWorkQueue::Orchestrators() {
  ASSIGN_OR_RETURN(const std::vector<std::string> reports,
                   store_->database().Texts("SELECT status FROM orchestrators WHERE report_time_us >= ? ORDER BY id",
                                            absl::ToUnixMicros(clock_.Now() - kStatusLife)));
  std::vector<v1::OrchestratorStatus> statuses;
  for (const std::string& report : reports) {
    if (!statuses.emplace_back().ParseFromString(report)) statuses.pop_back();
  }
  return statuses;
}

void SqliteWorkQueue::Listen(Listener listener) {
  std::lock_guard lock(listener_mutex_);
  listener_ = std::move(listener);
}

void SqliteWorkQueue::NotifyChanged(const std::string& job_id) {
  std::lock_guard lock(listener_mutex_);
  listener_.changed(job_id);
}

void SqliteWorkQueue::NotifyBatchChanged(const std::string& batch_id) {
  std::lock_guard lock(listener_mutex_);
  listener_.batch_changed(batch_id);
}

void SqliteWorkQueue::NotifyWork() {
  std::lock_guard lock(listener_mutex_);
  listener_.work();
}

void SqliteWorkQueue::Forget(const std::string& job_id) {
  std::lock_guard lock(mutex_);
  held_.erase(job_id);
}

void SqliteWorkQueue::CancelHeld(const std::string& job_id) {
  std::shared_ptr<runtime::Cancellation> cancellation;
  {
    std::lock_guard lock(mutex_);
    const auto found = held_.find(job_id);
    if (found == held_.end()) return;
    cancellation = found->second;
  }
  cancellation->Cancel();
}

void SqliteWorkQueue::HonourCancelRequests() {
  std::vector<std::string> held;
  {
    std::lock_guard lock(mutex_);
    for (const auto& [id, cancellation] : held_) held.push_back(id);
  }
  for (const std::string& id : held) {
    const absl::StatusOr<bool> requested = store_->jobs().CancelRequested(id);
    if (requested.ok() && *requested) CancelHeld(id);
  }
}

void SqliteWorkQueue::OnChange() {
  HonourCancelRequests();
  NotifyChanged("");
  NotifyBatchChanged("");
  NotifyWork();
}

void SqliteWorkQueue::OnOwnerGone() {
  (void)store_->ReleaseDeadOwners();
  const absl::StatusOr<bool> delay_passed = store_->jobs().AnyDelayPassed(clock_.Now());
  const absl::StatusOr<std::string> alone = store_->jobs().OldestWaiting("", clock_.Now());
  const bool work = (delay_passed.ok() && *delay_passed) || (alone.ok() && !alone->empty());
  if (work) NotifyWork();
}

}  // namespace flair::orchestrator
