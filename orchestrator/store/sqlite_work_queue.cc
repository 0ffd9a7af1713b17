// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/sqlite_work_queue.h"

#include <fmt/format.h>

#include <utility>

#include "orchestrator/store/sqlite_lease.h"

namespace flair::orchestrator {
namespace {
// An orchestrator that has said nothing for so long is not counted any more.
constexpr absl::Duration kStatusLife = absl::Seconds(10);
}  // namespace

absl::StatusOr<std::unique_ptr<WorkQueue>> SqliteWorkQueue::Open(const std::string& path, const runtime::Clock& clock) {
  absl::StatusOr<std::unique_ptr<JobStore>> store = JobStore::Open(path);
  if (!store.ok()) return store.status();
  return std::unique_ptr<WorkQueue>(new SqliteWorkQueue(*std::move(store), clock));
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
  int lost_run_count = 0;
  {
    auto transaction = Transaction::Begin(store_->database());
    if (!transaction.ok()) return transaction.status();
    absl::StatusOr<std::string> chosen = ChooseJob(filter);
    if (!chosen.ok()) return chosen.status();
    if (chosen->empty()) return nullptr;
    id = *std::move(chosen);
    if (absl::Status status = store_->jobs().Claim(id, store_->owner()).status(); !status.ok()) return status;
    absl::StatusOr<v1::Job> taken = store_->jobs().Get(id);
    if (!taken.ok()) return taken.status();
    job = *std::move(taken);
    auto events = store_->events().After(id, 0, 10000);
    if (!events.ok()) return events.status();
    history = *std::move(events);
    const absl::StatusOr<int> lost = store_->jobs().LostRunCount(id);
    if (!lost.ok()) return lost.status();
    lost_run_count = *lost;
    if (absl::Status status = transaction->Commit(); !status.ok()) return status;
  }
  auto cancellation = std::make_shared<runtime::Cancellation>();
  {
    std::lock_guard lock(mutex_);
    held_[id] = cancellation;
    if (!job.batch_id().empty()) last_batch_ = job.batch_id();
  }
  auto lease = std::make_unique<SqliteLease>(*this, std::move(job), std::move(history), lost_run_count, cancellation);
  if (lease->cancel_requested()) cancellation->Cancel();
  return lease;
}

absl::StatusOr<std::string> SqliteWorkQueue::ChooseJob(const TakeFilter& filter) {
  const absl::Time now = clock_.Now();
  if (filter.any) {
    absl::StatusOr<std::string> alone = store_->jobs().OldestWaiting("", now);
    return !alone.ok() || !alone->empty() ? alone : ChooseOfAnyBatch();
  }
  for (const std::string& id : filter.job_ids) {
    const absl::StatusOr<v1::Job> job = store_->jobs().Get(id);
    if (absl::IsNotFound(job.status())) continue;
    if (!job.ok()) return job.status();
    if (job->state() == v1::JOB_STATE_QUEUED) return id;
  }
  for (const std::string& batch_id : filter.batch_ids) {
    const absl::StatusOr<bool> active = BatchIsActive(batch_id);
    if (!active.ok()) return active.status();
    if (!*active) continue;
    absl::StatusOr<std::string> id = store_->jobs().OldestWaiting(batch_id, now);
    if (!id.ok() || !id->empty()) return id;
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
    absl::StatusOr<std::string> next = store_->jobs().NextBatchWaiting(at);
    if (!next.ok()) return next;
    if (next->empty() && !wrapped) {
      wrapped = true;
      at = "";
      continue;
    }
    if (next->empty() || (wrapped && *next > start)) return "";
    at = *std::move(next);
    const absl::StatusOr<bool> active = BatchIsActive(at);
    if (!active.ok()) return active.status();
    if (!*active) continue;
    absl::StatusOr<std::string> id = store_->jobs().OldestWaiting(at, now);
    if (!id.ok() || !id->empty()) return id;
  }
}

absl::StatusOr<bool> SqliteWorkQueue::BatchIsActive(const std::string& batch_id) {
  const absl::StatusOr<v1::Batch> batch = store_->batches().Get(batch_id);
  if (absl::IsNotFound(batch.status())) return false;
  if (!batch.ok()) return batch.status();
  return batch->state() == v1::BATCH_STATE_ACTIVE;
}

absl::StatusOr<std::optional<v1::ArtifactRef>> SqliteWorkQueue::FindResult(const std::string& brief,
                                                                           const std::string& key) {
  const int64_t seen = no_results_.generation();
  if (no_results_.Contains(brief)) return std::nullopt;
  auto found = store_->artifacts().FindResult(brief, key);
  if (!found.ok() || found->has_value()) return found;
  const absl::StatusOr<bool> any = store_->artifacts().HasResults(brief);
  if (any.ok() && !*any) no_results_.Add(brief, seen);
  return found;
}

absl::StatusOr<v1::Job> SqliteWorkQueue::GetJob(const std::string& job_id) { return store_->jobs().Get(job_id); }

absl::StatusOr<std::vector<v1::Job>> SqliteWorkQueue::ListJobs(const ListFilter& filter) {
  return store_->jobs().List(filter);
}

absl::StatusOr<std::vector<v1::JobEvent>> SqliteWorkQueue::EventsAfter(const std::string& job_id, int64_t sequence,
                                                                       int limit) {
  return store_->events().After(job_id, sequence, limit);
}

absl::StatusOr<v1::Batch> SqliteWorkQueue::GetBatch(const std::string& batch_id) {
  return store_->batches().GetWithCounts(batch_id);
}

absl::StatusOr<v1::Batch> SqliteWorkQueue::FindBatch(const std::string& batch_id) {
  return store_->batches().Get(batch_id);
}

absl::StatusOr<std::vector<v1::Batch>> SqliteWorkQueue::ListBatches(const ListFilter& filter) {
  return store_->batches().List(filter);
}

absl::StatusOr<bool> SqliteWorkQueue::BatchHasEnded(const std::string& batch_id) {
  const absl::StatusOr<v1::Batch> batch = store_->batches().Get(batch_id);
  if (!batch.ok()) return batch.status();
  if (batch->open()) return false;
  for (const v1::JobState state : {v1::JOB_STATE_QUEUED, v1::JOB_STATE_RUNNING}) {
    const auto ids = store_->jobs().IdsOf(batch_id, state, 1);
    if (!ids.ok()) return ids.status();
    if (!ids->empty()) return false;
  }
  return true;
}

absl::StatusOr<std::vector<BatchEnd>> SqliteWorkQueue::EndsAfter(const std::string& batch_id, int64_t sequence,
                                                                 int limit) {
  return store_->batches().EndsAfter(batch_id, sequence, limit);
}

absl::StatusOr<int64_t> SqliteWorkQueue::CountQueued() { return store_->jobs().CountQueued(); }

absl::StatusOr<int64_t> SqliteWorkQueue::CountOpen(const std::string& owner) { return store_->jobs().CountOpen(owner); }

absl::StatusOr<bool> SqliteWorkQueue::OwnsArtifact(const std::string& owner, const std::string& artifact_id) {
  return store_->jobs().OwnsArtifact(owner, artifact_id);
}

absl::Status SqliteWorkQueue::ReportStatus(const v1::OrchestratorStatus& status) {
  const absl::Time now = clock_.Now();
  return store_->statuses().Set(status, now, now - kStatusLife);
}

absl::StatusOr<std::vector<v1::OrchestratorStatus>> SqliteWorkQueue::Orchestrators() {
  return store_->statuses().Since(clock_.Now() - kStatusLife);
}

void SqliteWorkQueue::Listen(Listener listener) {
  std::lock_guard lock(listener_mutex_);
  listener_ = std::move(listener);
}

void SqliteWorkQueue::Tell(const std::string& job_id) {
  std::lock_guard lock(listener_mutex_);
  listener_.changed(job_id);
}

void SqliteWorkQueue::TellOfBatch(const std::string& batch_id) {
  std::lock_guard lock(listener_mutex_);
  listener_.batch_changed(batch_id);
}

void SqliteWorkQueue::TellOfWork() {
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
  no_results_.ForgetAll();
  HonourCancelRequests();
  Tell("");
  TellOfBatch("");
  TellOfWork();
}

void SqliteWorkQueue::OnOwnerGone() {
  (void)store_->ReleaseDeadOwners();
  const absl::StatusOr<bool> delay_passed = store_->jobs().AnyDelayPassed(clock_.Now());
  const absl::StatusOr<std::string> alone = store_->jobs().OldestWaiting("", clock_.Now());
  const bool work = (delay_passed.ok() && *delay_passed) || (alone.ok() && !alone->empty());
  if (work) TellOfWork();
}

}  // namespace flair::orchestrator
