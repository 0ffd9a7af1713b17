// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that have ended are forgotten. What is forgotten is safe against loss of power before a file of it goes.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "orchestrator/store/sqlite_work_queue.h"

namespace flair::orchestrator {
namespace {

// As many at once as others can wait for.
constexpr int kJobsRemovedAtOnce = 200;
constexpr int kFilesRemovedAtOnce = 200;

// Whatever has been stored: that nobody has it is asked under the same lock.
constexpr int64_t kWhenever = std::numeric_limits<int64_t>::max();

}  // namespace

absl::StatusOr<Deleted> SqliteWorkQueue::DeleteJob(const std::string& job_id, ArtifactStore& artifacts) {
  {
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const absl::StatusOr<v1::Job> job = store_->jobs().Get(job_id);
    if (!job.ok()) return job.status();
    absl::Status status = CheckDeletable(*job);
    if (status.ok()) status = store_->deletions().RemoveJob(job_id);
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  absl::StatusOr<Deleted> deleted = FinishDeletions(artifacts);
  if (!deleted.ok()) return deleted;
  deleted->job_count = 1;
  return deleted;
}

absl::StatusOr<Deleted> SqliteWorkQueue::DeleteBatch(const std::string& batch_id, int job_limit,
                                                     ArtifactStore& artifacts) {
  Deleted all;
  while (!all.done && all.job_count < job_limit) {
    const int64_t count = std::min<int64_t>(kJobsRemovedAtOnce, job_limit - all.job_count);
    const absl::StatusOr<Deleted> some = RemoveLastJobs(batch_id, count);
    if (!some.ok()) return some.status();
    const absl::StatusOr<Deleted> files = FinishDeletions(artifacts);
    if (!files.ok()) return files.status();
    all.job_count += some->job_count;
    all.artifact_count += files->artifact_count;
    all.done = some->done;
  }
  TellOfBatch(batch_id);
  return all;
}

// The jobs at the last places, so that what is left is a batch too; and the batch when none is left.
absl::StatusOr<Deleted> SqliteWorkQueue::RemoveLastJobs(const std::string& batch_id, int64_t limit) {
  auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
  if (!transaction.ok()) return transaction.status();
  const absl::StatusOr<v1::Batch> batch = store_->batches().Get(batch_id);
  if (!batch.ok()) return batch.status();
  const absl::StatusOr<bool> ended = BatchHasEnded(batch_id);
  if (!ended.ok()) return ended.status();
  absl::Status status = CheckDeletable(*batch, *ended);
  Deleted removed{.job_count = std::min<int64_t>(batch->job_count(), limit)};
  const int64_t left = batch->job_count() - removed.job_count;
  for (int64_t i = left; status.ok() && i < batch->job_count(); ++i) {
    status = store_->deletions().RemoveJob(BatchJobId(batch_id, i));
  }
  removed.done = left == 0;
  if (status.ok() && removed.done) status = store_->deletions().RemoveBatch(batch_id);
  // None of those that are left is run again.
  if (status.ok() && !removed.done) status = store_->batches().SetState(batch_id, v1::BATCH_STATE_CANCELLED);
  if (status.ok() && !removed.done) status = store_->batches().SetJobs(batch_id, left, false);
  if (status.ok()) status = transaction->Commit();
  if (!status.ok()) return status;
  return removed;
}

absl::StatusOr<Deleted> SqliteWorkQueue::FinishDeletions(ArtifactStore& artifacts) {
  Deleted deleted;
  // Most of the time nothing waits, and nobody else is made to.
  const auto any = store_->deletions().Pending(1);
  if (!any.ok()) return any.status();
  deleted.done = any->empty();
  while (!deleted.done) {
    auto transaction = Transaction::Begin(store_->database());
    if (!transaction.ok()) return transaction.status();
    const auto pending = store_->deletions().Pending(kFilesRemovedAtOnce);
    if (!pending.ok()) return pending.status();
    deleted.done = static_cast<int>(pending->size()) < kFilesRemovedAtOnce;
    absl::Status status;
    for (const std::string& id : *pending) {
      if (status.ok()) status = DeleteUnlessHad(id, artifacts, deleted.artifact_count);
    }
    if (status.ok()) status = store_->deletions().Trim();
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  return deleted;
}

absl::Status SqliteWorkQueue::DeleteUnlessHad(const std::string& artifact_id, ArtifactStore& artifacts,
                                              int64_t& deleted_count) {
  const absl::StatusOr<bool> had = store_->deletions().IsHad(artifact_id);
  if (!had.ok()) return had.status();
  if (*had) return store_->deletions().Spare(artifact_id);
  const absl::StatusOr<int64_t> deleted = artifacts.Delete(std::span(&artifact_id, 1), kWhenever);
  if (!deleted.ok()) return deleted.status();
  deleted_count += *deleted;
  return store_->deletions().SetDeleted(artifact_id);
}

absl::StatusOr<EndedPage> SqliteWorkQueue::EndedBefore(absl::Time time, const std::string& after, int limit) {
  EndedPage page;
  // Those that stand alone are found at once, and are deleted before the next page is asked for.
  absl::StatusOr<std::vector<std::string>> jobs = store_->deletions().JobsEndedBefore(time, limit);
  if (!jobs.ok()) return jobs.status();
  page.job_ids = *std::move(jobs);
  const auto closed = store_->deletions().ClosedBatches(after, limit);
  if (!closed.ok()) return closed.status();
  for (const std::string& id : *closed) {
    const absl::StatusOr<absl::Time> last_end = store_->deletions().LastEndOf(id);
    if (!last_end.ok()) return last_end.status();
    if (*last_end >= time) continue;
    const absl::StatusOr<bool> ended = BatchHasEnded(id);
    // Somebody else may have deleted it just now.
    if (!ended.ok() && !absl::IsNotFound(ended.status())) return ended.status();
    if (ended.ok() && *ended) page.batch_ids.push_back(id);
  }
  if (static_cast<int>(closed->size()) == limit) page.next = closed->back();
  return page;
}

}  // namespace flair::orchestrator
