// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to the queue in a folder: jobs and batches are made, cancelled, retried.

#include <algorithm>
#include <limits>

#include "orchestrator/batch/job_rules.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Jobs ended in one transaction when a batch is cancelled: others write in between.
constexpr int kCancelledAtOnce = 500;

// As many at once as others can wait for.
constexpr int kJobsRemovedAtOnce = 200;
constexpr int kFilesRemovedAtOnce = 200;

// Whenever it was stored: that no job has it is checked under the same lock.
constexpr int64_t kWhenever = std::numeric_limits<int64_t>::max();

}  // namespace

absl::StatusOr<v1::Job> SqliteWorkQueue::CreateJob(const v1::Job& job, const std::string& request_id,
                                                   const GivenArtifact* given) {
  const store::v1::JobRecord record = NewRecord(job, request_id, given);
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(const std::string known, store_->jobs().FindByRequest(request_id));
    if (!known.empty()) return store_->jobs().Get(known);
    RETURN_IF_ERROR(store_->jobs().Insert(job, request_id));
    if (given != nullptr) {
      // Nobody deletes artifacts during the transaction.
      RETURN_IF_ERROR(given->store->PutAll(std::span(&given->artifact, 1)));
      RETURN_IF_ERROR(given->store->Flush(std::span(&given->artifact.ref, 1)));
      RETURN_IF_ERROR(store_->jobs().Save(record, 0));
    }
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyWork();
  return record.job();
}

absl::StatusOr<store::v1::BatchRecord> SqliteWorkQueue::CreateBatch(const store::v1::BatchRecord& batch) {
  ASSIGN_OR_RETURN(auto transaction, BeginDurable());
  ASSIGN_OR_RETURN(auto known, store_->batches().FindByRequest(batch.request_id()));
  if (known.has_value()) return *std::move(known);
  RETURN_IF_ERROR(store_->batches().Insert(batch));
  RETURN_IF_ERROR(transaction.Commit());
  return batch;
}

absl::StatusOr<bool> SqliteWorkQueue::HasRequest(RequestKind kind, const std::string&, const std::string& request_id) {
  if (kind == RequestKind::kBatch) {
    ASSIGN_OR_RETURN(const auto batch, store_->batches().FindByRequest(request_id));
    return batch.has_value();
  }
  ASSIGN_OR_RETURN(const std::string job, store_->jobs().FindByRequest(request_id));
  return !job.empty();
}

absl::StatusOr<v1::Batch> SqliteWorkQueue::AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs,
                                                   bool last) {
  v1::Batch batch;
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(batch, store_->batches().Get(batch_id));
    const int64_t known_count = batch.job_count();
    ASSIGN_OR_RETURN(const bool changed, GrowBatch(jobs, last, batch));
    for (const v1::Job& job : jobs) {
      if (job.batch_index() >= known_count) {
        RETURN_IF_ERROR(store_->jobs().Insert(job, ""));
      } else {
        ASSIGN_OR_RETURN(const v1::Job known, store_->jobs().Get(job.id()));
        RETURN_IF_ERROR(CheckSameSpec(known, job));
      }
    }
    if (!changed) return batch;
    RETURN_IF_ERROR(store_->batches().Save(batch));
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyWork();
  NotifyBatchChanged(batch_id);
  return batch;
}

absl::Status SqliteWorkQueue::Cancel(const std::string& job_id, absl::Time now) {
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    const auto cancel = [now](store::v1::JobRecord& record) { return CancelJob(record, now); };
    RETURN_IF_ERROR(ChangeJob(job_id, cancel).status());
    RETURN_IF_ERROR(transaction.Commit());
  }
  CancelHeld(job_id);
  NotifyChanged(job_id);
  NotifyBatchChanged("");
  return absl::OkStatus();
}

absl::StatusOr<bool> SqliteWorkQueue::Retry(const std::string& job_id) {
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    bool waits = false;
    const auto retry = [&](store::v1::JobRecord& record) -> absl::StatusOr<bool> {
      if (!record.job().batch_id().empty()) {
        ASSIGN_OR_RETURN(const v1::Batch batch, store_->batches().Get(record.job().batch_id()));
        if (batch.state() == v1::BATCH_STATE_CANCELLED) return false;
      }
      waits = RetryJob(record);
      return waits;
    };
    RETURN_IF_ERROR(ChangeJob(job_id, retry).status());
    if (!waits) return false;
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyChanged(job_id);
  NotifyWork();
  return true;
}

absl::Status SqliteWorkQueue::ChangeBatch(const std::string& batch_id,
                                          const std::function<absl::StatusOr<bool>(v1::Batch&)>& change) {
  ASSIGN_OR_RETURN(auto transaction, BeginDurable());
  ASSIGN_OR_RETURN(v1::Batch batch, store_->batches().Get(batch_id));
  ASSIGN_OR_RETURN(const bool changed, change(batch));
  if (!changed) return absl::OkStatus();
  RETURN_IF_ERROR(store_->batches().Save(batch));
  return transaction.Commit();
}

absl::Status SqliteWorkQueue::SetBatchState(const std::string& batch_id, v1::BatchState state) {
  RETURN_IF_ERROR(
      ChangeBatch(batch_id, [state](v1::Batch& batch) { return orchestrator::SetBatchState(state, batch); }));
  NotifyWork();
  return absl::OkStatus();
}

absl::Status SqliteWorkQueue::CancelBatch(const std::string& batch_id, absl::Time now) {
  // First nobody takes its jobs any more; then those that run are told; then those that wait are ended, as many at once
  // as others can wait for.
  RETURN_IF_ERROR(ChangeBatch(batch_id, [](v1::Batch& batch) { return orchestrator::CancelBatch(batch); }));
  const auto cancel = [now](store::v1::JobRecord& record) { return CancelJob(record, now); };
  for (const v1::JobState state : {v1::JOB_STATE_RUNNING, v1::JOB_STATE_QUEUED}) {
    const int limit = state == v1::JOB_STATE_QUEUED ? kCancelledAtOnce : std::numeric_limits<int>::max();
    for (bool more = true; more;) {
      ASSIGN_OR_RETURN(auto transaction, BeginDurable());
      ASSIGN_OR_RETURN(const auto ids, store_->jobs().IdsOf(batch_id, state, limit));
      for (const std::string& id : ids) RETURN_IF_ERROR(ChangeJob(id, cancel).status());
      RETURN_IF_ERROR(transaction.Commit());
      more = static_cast<int>(ids.size()) == limit;
    }
  }
  HonourCancelRequests();
  NotifyChanged("");
  NotifyBatchChanged(batch_id);
  return absl::OkStatus();
}

// Jobs that have ended are deleted: their rows first, safe against loss of power, then the artifacts that no job has.

absl::StatusOr<Deleted> SqliteWorkQueue::DeleteJob(const std::string& job_id, ArtifactStore& artifacts) {
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(const v1::Job job, store_->jobs().Get(job_id));
    RETURN_IF_ERROR(CheckDeletable(job));
    RETURN_IF_ERROR(store_->deletions().RemoveJob(job_id));
    RETURN_IF_ERROR(transaction.Commit());
  }
  ASSIGN_OR_RETURN(Deleted deleted, FinishDeletions(artifacts));
  deleted.job_count = 1;
  return deleted;
}

absl::StatusOr<Deleted> SqliteWorkQueue::DeleteBatch(const std::string& batch_id, int job_limit,
                                                     ArtifactStore& artifacts) {
  Deleted all;
  while (!all.done && all.job_count < job_limit) {
    const int64_t count = std::min<int64_t>(kJobsRemovedAtOnce, job_limit - all.job_count);
    ASSIGN_OR_RETURN(const Deleted some, RemoveLastJobs(batch_id, count));
    ASSIGN_OR_RETURN(const Deleted files, FinishDeletions(artifacts));
    all.job_count += some.job_count;
    all.artifact_count += files.artifact_count;
    all.done = some.done;
  }
  NotifyBatchChanged(batch_id);
  return all;
}

// The jobs at the last places, so that what is left is a batch too; and the batch when none is left.
absl::StatusOr<Deleted> SqliteWorkQueue::RemoveLastJobs(const std::string& batch_id, int64_t limit) {
  ASSIGN_OR_RETURN(auto transaction, BeginDurable());
  ASSIGN_OR_RETURN(v1::Batch batch, store_->batches().Get(batch_id));
  ASSIGN_OR_RETURN(const bool ended, BatchHasEnded(batch_id));
  RETURN_IF_ERROR(CheckDeletable(batch, ended));
  const int64_t all = batch.job_count();
  Deleted removed{.job_count = std::min(all, limit)};
  const int64_t left = all - removed.job_count;
  for (int64_t i = left; i < all; ++i) RETURN_IF_ERROR(store_->deletions().RemoveJob(BatchJobId(batch_id, i)));
  removed.done = left == 0;
  if (removed.done) {
    RETURN_IF_ERROR(store_->deletions().RemoveBatch(batch_id));
  } else {
    // None of those that are left is run again.
    orchestrator::CancelBatch(batch);
    batch.set_job_count(static_cast<int>(left));
    RETURN_IF_ERROR(store_->batches().Save(batch));
  }
  RETURN_IF_ERROR(transaction.Commit());
  return removed;
}

absl::StatusOr<Deleted> SqliteWorkQueue::FinishDeletions(ArtifactStore& artifacts) {
  Deleted deleted;
  // Most of the time nothing waits, and nobody else is made to.
  ASSIGN_OR_RETURN(const auto any, store_->deletions().Pending(1));
  deleted.done = any.empty();
  while (!deleted.done) {
    ASSIGN_OR_RETURN(auto transaction, Transaction::Begin(store_->database()));
    ASSIGN_OR_RETURN(const auto pending, store_->deletions().Pending(kFilesRemovedAtOnce));
    deleted.done = static_cast<int>(pending.size()) < kFilesRemovedAtOnce;
    for (const std::string& id : pending) RETURN_IF_ERROR(DeleteUnlessUsed(id, artifacts, deleted.artifact_count));
    RETURN_IF_ERROR(store_->deletions().Trim());
    RETURN_IF_ERROR(transaction.Commit());
  }
  return deleted;
}

absl::Status SqliteWorkQueue::DeleteUnlessUsed(const std::string& artifact_id, ArtifactStore& artifacts,
                                               int64_t& deleted_count) {
  ASSIGN_OR_RETURN(const bool used, store_->deletions().IsUsed(artifact_id));
  if (used) return store_->deletions().Keep(artifact_id);
  ASSIGN_OR_RETURN(const int64_t deleted, artifacts.Delete(std::span(&artifact_id, 1), kWhenever));
  deleted_count += deleted;
  return store_->deletions().SetDeleted(artifact_id);
}

absl::StatusOr<EndedPage> SqliteWorkQueue::EndedBefore(absl::Time time, const std::string& after, int limit) {
  EndedPage page;
  // Jobs without a batch are found at once, and are deleted before the next page is asked for.
  ASSIGN_OR_RETURN(page.job_ids, store_->deletions().JobsEndedBefore(time, limit));
  ASSIGN_OR_RETURN(const auto closed, store_->deletions().ClosedBatches(after, limit));
  for (const std::string& id : closed) {
    ASSIGN_OR_RETURN(const absl::Time last_end, store_->deletions().LastEndOf(id));
    if (last_end >= time) continue;
    ASSIGN_OR_RETURN(const std::optional<bool> ended, IfFound(BatchHasEnded(id)));
    // Somebody else may have deleted it just now.
    if (ended.value_or(false)) page.batch_ids.push_back(id);
  }
  if (static_cast<int>(closed.size()) == limit) page.next = closed.back();
  return page;
}

}  // namespace flair::orchestrator
