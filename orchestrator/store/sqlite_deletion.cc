// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that have ended are deleted: their rows first, safe against loss of power, then the artifacts that no job has.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "orchestrator/batch/job_rules.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// As many at once as others can wait for.
constexpr int kJobsRemovedAtOnce = 200;
constexpr int kFilesRemovedAtOnce = 200;

// Whenever it was stored: that no job has it is checked under the same lock.
constexpr int64_t kWhenever = std::numeric_limits<int64_t>::max();

}  // namespace

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
  for (int64_t i = left; i < all; ++i) {
    RETURN_IF_ERROR(store_->deletions().RemoveJob(BatchJobId(batch_id, i)));
  }
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
    for (const std::string& id : pending) {
      RETURN_IF_ERROR(DeleteUnlessUsed(id, artifacts, deleted.artifact_count));
    }
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
