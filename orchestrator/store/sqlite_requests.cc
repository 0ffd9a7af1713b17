// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to the queue in a folder: jobs and batches are made, cancelled, retried.
#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Jobs ended in one transaction when a batch is cancelled: others write in between.
constexpr int kCancelledAtOnce = 500;

absl::Status CheckPlace(const v1::Job& job, const v1::Batch& batch) {
  if (job.batch_index() > batch.job_count()) {
    return absl::FailedPreconditionError(
        fmt::format("first_index: {} leaves a gap: batch {} has {} jobs; add from {} on", job.batch_index(), batch.id(),
                    batch.job_count(), batch.job_count()));
  }
  if (batch.open()) return absl::OkStatus();
  return absl::FailedPreconditionError(
      fmt::format("batch_id: {} is closed with {} jobs; make another batch", batch.id(), batch.job_count()));
}

}  // namespace

absl::StatusOr<v1::Job> SqliteWorkQueue::CreateJob(const v1::Job& job, const std::string& request_id) {
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(const std::string known, store_->jobs().FindByRequest(request_id));
    if (!known.empty()) return store_->jobs().Get(known);
    RETURN_IF_ERROR(store_->jobs().Insert(job, request_id));
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyWork();
  return job;
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
    ASSIGN_OR_RETURN(const int64_t job_count, AddNewJobs(batch, jobs));
    const bool open = batch.open() && !last;
    if (job_count == batch.job_count() && open == batch.open()) return batch;
    batch.set_job_count(static_cast<int>(job_count));
    batch.set_open(open);
    RETURN_IF_ERROR(store_->batches().SetJobs(batch_id, job_count, open));
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyWork();
  NotifyBatchChanged(batch_id);
  return batch;
}

// The number of jobs that the batch then has.
absl::StatusOr<int64_t> SqliteWorkQueue::AddNewJobs(const v1::Batch& batch, std::span<const v1::Job> jobs) {
  v1::Batch grown = batch;
  for (const v1::Job& job : jobs) {
    if (job.batch_index() < grown.job_count()) {
      ASSIGN_OR_RETURN(const v1::Job known, store_->jobs().Get(job.id()));
      if (runtime::CanonicalBytes(known.spec()) == runtime::CanonicalBytes(job.spec())) continue;
      return absl::AlreadyExistsError(fmt::format("specs: place {} of batch {} has another spec; make another batch",
                                                  job.batch_index(), batch.id()));
    }
    RETURN_IF_ERROR(CheckPlace(job, grown));
    RETURN_IF_ERROR(store_->jobs().Insert(job, ""));
    grown.set_job_count(grown.job_count() + 1);
  }
  return grown.job_count();
}

absl::Status SqliteWorkQueue::AppendEnded(const v1::Job& job) {
  v1::JobEvent event;
  event.set_job_id(job.id());
  event.set_kind(v1::JOB_EVENT_KIND_ENDED);
  event.set_message(job.error());
  event.set_state(job.state());
  RETURN_IF_ERROR(store_->jobs().AppendEvent(event));
  return job.batch_id().empty() ? absl::OkStatus() : store_->batches().AddEnd(job.batch_id(), job.id());
}

absl::StatusOr<bool> SqliteWorkQueue::EndWaitingJob(const std::string& job_id, const std::string& batch_id,
                                                    absl::Time time) {
  ASSIGN_OR_RETURN(const bool ended, store_->jobs().CancelWaiting(job_id, time));
  if (!ended) return false;
  v1::Job job;
  job.set_id(job_id);
  job.set_batch_id(batch_id);
  job.set_state(v1::JOB_STATE_CANCELLED);
  RETURN_IF_ERROR(AppendEnded(job));
  return true;
}

absl::Status SqliteWorkQueue::Cancel(const std::string& job_id, absl::Time now) {
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(const v1::Job job, store_->jobs().Get(job_id));
    if (job.state() != v1::JOB_STATE_QUEUED && job.state() != v1::JOB_STATE_RUNNING) return absl::OkStatus();
    ASSIGN_OR_RETURN(const bool ended, EndWaitingJob(job_id, job.batch_id(), now));
    if (!ended) RETURN_IF_ERROR(store_->jobs().RequestCancel(job_id));
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
    ASSIGN_OR_RETURN(const v1::Job job, store_->jobs().Get(job_id));
    if (!job.batch_id().empty()) {
      ASSIGN_OR_RETURN(const v1::Batch batch, store_->batches().Get(job.batch_id()));
      if (batch.state() == v1::BATCH_STATE_CANCELLED) return false;
    }
    ASSIGN_OR_RETURN(const bool waits, store_->jobs().Retry(job_id));
    if (!waits) return false;
    v1::JobEvent event;
    event.set_job_id(job_id);
    event.set_kind(v1::JOB_EVENT_KIND_RETRIED);
    event.set_state(v1::JOB_STATE_QUEUED);
    RETURN_IF_ERROR(store_->jobs().AppendEvent(event));
    RETURN_IF_ERROR(store_->batches().RemoveEnd(job_id));
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyChanged(job_id);
  NotifyWork();
  return true;
}

absl::Status SqliteWorkQueue::SetBatchState(const std::string& batch_id, v1::BatchState state) {
  {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(const v1::Batch batch, store_->batches().Get(batch_id));
    if (batch.state() == v1::BATCH_STATE_CANCELLED) {
      if (state != v1::BATCH_STATE_ACTIVE) return absl::OkStatus();
      return absl::FailedPreconditionError(fmt::format("batch_id: {} is cancelled; make another batch", batch_id));
    }
    RETURN_IF_ERROR(store_->batches().SetState(batch_id, state));
    RETURN_IF_ERROR(transaction.Commit());
  }
  NotifyWork();
  return absl::OkStatus();
}

absl::Status SqliteWorkQueue::CloseCancelled(const std::string& batch_id) {
  ASSIGN_OR_RETURN(auto transaction, BeginDurable());
  ASSIGN_OR_RETURN(const v1::Batch batch, store_->batches().Get(batch_id));
  RETURN_IF_ERROR(store_->batches().SetState(batch_id, v1::BATCH_STATE_CANCELLED));
  RETURN_IF_ERROR(store_->batches().SetJobs(batch_id, batch.job_count(), false));
  RETURN_IF_ERROR(store_->jobs().RequestCancelOfBatch(batch_id));
  return transaction.Commit();
}

absl::Status SqliteWorkQueue::CancelBatch(const std::string& batch_id, absl::Time now) {
  // First nobody takes its jobs any more; then those that wait are ended, as many at once as others can wait for.
  RETURN_IF_ERROR(CloseCancelled(batch_id));
  for (bool more = true; more;) {
    ASSIGN_OR_RETURN(auto transaction, BeginDurable());
    ASSIGN_OR_RETURN(const auto ids, store_->jobs().IdsOf(batch_id, v1::JOB_STATE_QUEUED, kCancelledAtOnce));
    for (const std::string& id : ids) RETURN_IF_ERROR(EndWaitingJob(id, batch_id, now).status());
    RETURN_IF_ERROR(transaction.Commit());
    more = static_cast<int>(ids.size()) == kCancelledAtOnce;
  }
  HonourCancelRequests();
  NotifyChanged("");
  NotifyBatchChanged(batch_id);
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
