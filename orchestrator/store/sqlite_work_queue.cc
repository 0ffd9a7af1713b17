// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/sqlite_work_queue.h"

#include <fmt/format.h>

#include <utility>

#include "orchestrator/store/sqlite_lease.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {
// An orchestrator that has said nothing for so long is not counted any more.
constexpr absl::Duration kStatusLife = absl::Seconds(10);
}  // namespace

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
