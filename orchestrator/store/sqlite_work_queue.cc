// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/sqlite_work_queue.h"

#include <algorithm>
#include <span>
#include <utility>

#include "orchestrator/batch/job_rules.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {
// An orchestrator that has said nothing for so long is not counted any more.
constexpr absl::Duration kStatusLife = absl::Seconds(10);

// Of a job that the store itself named: that it is not there, or has parts that it was not said to have, is damage.
absl::Status OrDamaged(const JobStore& store, const absl::Status& status) {
  if (!absl::IsNotFound(status) && !absl::IsAlreadyExists(status)) return status;
  return Damaged(store.path() + "/jobs.db", std::string(status.message()));
}
}  // namespace

// A run of a job in a store. Every write asks in its own transaction whether the run still holds the job.
class SqliteLease final : public Lease {
 public:
  SqliteLease(SqliteWorkQueue& queue, store::v1::JobRecord taken, std::shared_ptr<runtime::Cancellation> cancellation)
      : Lease(std::move(taken)), queue_(queue), store_(*queue.store_), cancellation_(std::move(cancellation)) {}

  ~SqliteLease() override {
    if (!done_ && !lost_) (void)Return(absl::ZeroDuration(), "");
    queue_.Forget(job().id());
  }

  // Nothing to do: RecordAll and deletions exclude each other.
  absl::Status Announce(std::span<const StageRecord>) override { return absl::OkStatus(); }

  absl::Status RecordAll(std::span<const StageRecord> records) override {
    if (records.empty()) return absl::OkStatus();
    RETURN_IF_ERROR(Write(Transaction::Durability::kProcessCrash, records,
                          [&](store::v1::JobRecord& record) { AddStageRecords(record, records); }));
    queue_.NotifyChanged(job().id());
    return absl::OkStatus();
  }

  absl::Status End(const JobEnd& end) override {
    RETURN_IF_ERROR(Write(Transaction::Durability::kPowerLoss, end.records,
                          [&](store::v1::JobRecord& record) { EndJob(record, end); }));
    done_ = true;
    queue_.NotifyChanged(job().id());
    if (!job().batch_id().empty()) queue_.NotifyBatchChanged(job().batch_id());
    return absl::OkStatus();
  }

  absl::Status Return(absl::Duration delay, const std::string& reason) override {
    const absl::Time not_before = delay > absl::ZeroDuration() ? queue_.clock_.Now() + delay : absl::InfinitePast();
    RETURN_IF_ERROR(Write(Transaction::Durability::kProcessCrash, {},
                          [&](store::v1::JobRecord& record) { ReturnJob(record, not_before, reason); }));
    done_ = true;
    queue_.NotifyChanged(job().id());
    queue_.NotifyWork();
    return absl::OkStatus();
  }

  runtime::Cancellation& cancellation() override { return *cancellation_; }

  bool cancel_requested() override {
    const absl::StatusOr<bool> requested = store_.jobs().CancelRequested(job().id());
    return requested.ok() && *requested;
  }

  bool lost() override { return lost_; }

 private:
  using Change = std::function<void(store::v1::JobRecord&)>;

  // Makes a change in one transaction; when that fails since one of the artifacts was deleted, settles their deletions.
  absl::Status Write(Transaction::Durability durability, std::span<const StageRecord> records, const Change& change) {
    const absl::Status status = WriteOnce(durability, records, change);
    if (IsArtifactGone(status)) SettleDeletions(records);
    return status;
  }

  // ABORTED when another run has the job, ArtifactIsGone when one of the artifacts may have been deleted.
  absl::Status WriteOnce(Transaction::Durability durability, std::span<const StageRecord> records,
                         const Change& change) {
    ASSIGN_OR_RETURN(auto transaction, Transaction::Begin(store_.database(), durability));
    const auto if_held = [&](store::v1::JobRecord& record) -> absl::StatusOr<bool> {
      lost_ = record.holder() != taken().holder() || record.job().attempt_count() != job().attempt_count();
      if (lost_) return Aborted("job {}: another run has it", job().id());
      change(record);
      return true;
    };
    RETURN_IF_ERROR(OrDamaged(store_, queue_.ChangeJob(job().id(), if_held).status()));
    RETURN_IF_ERROR(CheckNotDeleted(records));
    for (const StageRecord& record : records) {
      if (record.result_key.empty()) continue;
      RETURN_IF_ERROR(store_.jobs().SetResult(record.result_key, record.event.artifact()));
    }
    return transaction.Commit();
  }

  absl::Status CheckNotDeleted(std::span<const StageRecord> records) {
    ASSIGN_OR_RETURN(const bool any, store_.deletions().Any());
    if (!any) return absl::OkStatus();
    for (const StageRecord& record : records) {
      if (!record.event.has_artifact()) continue;
      const std::string& id = record.event.artifact().id();
      ASSIGN_OR_RETURN(const bool deleted, store_.deletions().WasDeleted(id, job().id()));
      if (deleted) return ArtifactIsGone(id);
    }
    return absl::OkStatus();
  }

  // Turns what waits for its deletion into what was deleted, so that the next run may store it.
  void SettleDeletions(std::span<const StageRecord> records) {
    for (const StageRecord& record : records) {
      const std::string& id = record.event.artifact().id();
      const absl::StatusOr<bool> deleted = store_.deletions().WasDeleted(id, job().id());
      if (deleted.ok() && *deleted) (void)store_.deletions().SetDeleted(id);
    }
  }

  SqliteWorkQueue& queue_;
  JobStore& store_;
  // Shared with the queue, which cancels it.
  const std::shared_ptr<runtime::Cancellation> cancellation_;
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

absl::StatusOr<store::v1::JobRecord> SqliteWorkQueue::ChangeJob(
    const std::string& job_id, const std::function<absl::StatusOr<bool>(store::v1::JobRecord&)>& change) {
  ASSIGN_OR_RETURN(store::v1::JobRecord record, store_->jobs().Load(job_id));
  const bool had_ended = HasEnded(record);
  const int stored_events = record.events_size();
  ASSIGN_OR_RETURN(const bool changed, change(record));
  if (!changed) return record;
  RETURN_IF_ERROR(store_->jobs().Save(record, stored_events));
  if (record.job().batch_id().empty() || HasEnded(record) == had_ended) return record;
  RETURN_IF_ERROR(had_ended ? store_->batches().RemoveEnd(job_id)
                            : store_->batches().AddEnd(record.job().batch_id(), job_id));
  return record;
}

absl::StatusOr<std::unique_ptr<Lease>> SqliteWorkQueue::Take(const TakeFilter& filter) {
  store::v1::JobRecord taken;
  const auto cancellation = std::make_shared<runtime::Cancellation>();
  {
    ASSIGN_OR_RETURN(auto transaction, Transaction::Begin(store_->database()));
    ASSIGN_OR_RETURN(const std::string id, ChooseJob(filter));
    if (id.empty()) return nullptr;
    const auto begin = [this](store::v1::JobRecord& record) -> absl::StatusOr<bool> {
      // Otherwise it would be run again and again.
      if (record.job().state() != v1::JOB_STATE_QUEUED) {
        return absl::NotFoundError(record.job().id() + " waits only by an index");
      }
      BeginRun(record, store_->owner());
      return true;
    };
    absl::StatusOr<store::v1::JobRecord> begun = ChangeJob(id, begin);
    RETURN_IF_ERROR(OrDamaged(*store_, begun.status()));
    taken = *std::move(begun);
    RETURN_IF_ERROR(store_->deletions().BeginRun(id));
    // Held before anybody sees it run: a run that nobody holds is released.
    {
      std::lock_guard lock(mutex_);
      held_[id] = cancellation;
      if (!taken.job().batch_id().empty()) last_batch_ = taken.job().batch_id();
    }
    if (absl::Status committed = transaction.Commit(); !committed.ok()) {
      Forget(id);
      return committed;
    }
  }
  auto lease = std::make_unique<SqliteLease>(*this, std::move(taken), cancellation);
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
    ASSIGN_OR_RETURN(const std::optional<v1::Job> job, IfFound(store_->jobs().Get(id)));
    if (job.has_value() && job->state() == v1::JOB_STATE_QUEUED) return id;
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
  ASSIGN_OR_RETURN(const std::optional<v1::Batch> batch, IfFound(store_->batches().Get(batch_id)));
  return batch.has_value() && batch->state() == v1::BATCH_STATE_ACTIVE;
}

absl::StatusOr<bool> SqliteWorkQueue::BatchHasEnded(const std::string& batch_id) {
  ASSIGN_OR_RETURN(const v1::Batch batch, store_->batches().Get(batch_id));
  if (batch.open()) return false;
  for (const v1::JobState state : {v1::JOB_STATE_QUEUED, v1::JOB_STATE_RUNNING}) {
    ASSIGN_OR_RETURN(const auto ids, store_->jobs().IdsOf(batch_id, state, 1));
    if (ids.empty()) continue;
    RETURN_IF_ERROR(CheckWhenStill());
    return false;
  }
  return true;
}

absl::Status SqliteWorkQueue::CheckWhenStill() {
  Stillness still = Stillness::kStill;
  if (still_ != still) return absl::OkStatus();
  const auto any_runs = [this]() -> absl::StatusOr<bool> {
    ASSIGN_OR_RETURN(const auto owners, store_->jobs().Owners());
    return std::any_of(owners.begin(), owners.end(), [this](const std::string& id) {
      std::lock_guard lock(mutex_);
      return id == store_->owner() ? !held_.empty() : !OwnerLock::IsDead(store_->owners_path(), id);
    });
  };
  ASSIGN_OR_RETURN(const bool delayed, store_->jobs().AnyDelayed(clock_.Now()));
  ASSIGN_OR_RETURN(const bool running, any_runs());
  if (delayed || running) return absl::OkStatus();
  RETURN_IF_ERROR(store_->database().CheckWhole());
  still_.compare_exchange_strong(still, Stillness::kChecked);
  // Jobs of this process that none of its runs has any more, unless one was taken meanwhile.
  ASSIGN_OR_RETURN(auto transaction, Transaction::Begin(store_->database()));
  ASSIGN_OR_RETURN(const bool taken, any_runs());
  if (taken) return absl::OkStatus();
  ASSIGN_OR_RETURN(const int64_t released, store_->jobs().Release(store_->owner()));
  RETURN_IF_ERROR(transaction.Commit());
  if (released > 0) NotifyWork();
  return absl::OkStatus();
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
  still_ = Stillness::kBusy;
  std::lock_guard lock(listener_mutex_);
  listener_.work();
}

void SqliteWorkQueue::Forget(const std::string& job_id) {
  std::lock_guard lock(mutex_);
  held_.erase(job_id);
}

void SqliteWorkQueue::CancelHeld(const std::string& job_id) {
  std::unique_lock lock(mutex_);
  const auto found = held_.find(job_id);
  if (found == held_.end()) return;
  const std::shared_ptr<runtime::Cancellation> cancellation = found->second;
  lock.unlock();
  cancellation->Cancel();
}

void SqliteWorkQueue::HonourCancelRequests() {
  std::unique_lock lock(mutex_);
  const auto held = held_;
  lock.unlock();
  for (const auto& [id, cancellation] : held) {
    const absl::StatusOr<bool> requested = store_->jobs().CancelRequested(id);
    if (requested.ok() && *requested) cancellation->Cancel();
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
  Stillness busy = Stillness::kBusy;
  still_.compare_exchange_strong(busy, Stillness::kStill);
  // Of one's own writes and of delays that have passed nobody else tells.
  std::lock_guard lock(listener_mutex_);
  listener_.work();
  listener_.batch_changed("");
}

}  // namespace flair::orchestrator
