// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of the queue in a folder: jobs and batches made, ended, retried.
#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/files/files.h"

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
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const absl::StatusOr<std::string> known = store_->jobs().FindByRequest(request_id);
    if (!known.ok()) return known.status();
    if (!known->empty()) return store_->jobs().Get(*known);
    absl::Status status = store_->jobs().Insert(job, request_id);
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  TellOfWork();
  return job;
}

absl::StatusOr<store::v1::BatchRecord> SqliteWorkQueue::CreateBatch(const store::v1::BatchRecord& batch) {
  auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
  if (!transaction.ok()) return transaction.status();
  auto known = store_->batches().FindByRequest(batch.request_id());
  if (!known.ok()) return known.status();
  if (known->has_value()) return **std::move(known);
  absl::Status status = store_->batches().Insert(batch);
  if (status.ok()) status = transaction->Commit();
  if (!status.ok()) return status;
  return batch;
}

absl::StatusOr<bool> SqliteWorkQueue::HasRequest(RequestKind kind, const std::string&, const std::string& request_id) {
  if (kind == RequestKind::kBatch) {
    const auto batch = store_->batches().FindByRequest(request_id);
    if (!batch.ok()) return batch.status();
    return batch->has_value();
  }
  const absl::StatusOr<std::string> job = store_->jobs().FindByRequest(request_id);
  if (!job.ok()) return job.status();
  return !job->empty();
}

absl::StatusOr<v1::Batch> SqliteWorkQueue::AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs,
                                                   bool last) {
  absl::StatusOr<v1::Batch> batch = absl::UnknownError("");
  {
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    batch = store_->batches().Get(batch_id);
    if (!batch.ok()) return batch;
    const absl::StatusOr<int64_t> job_count = AddNewJobs(*batch, jobs);
    if (!job_count.ok()) return job_count.status();
    const bool open = batch->open() && !last;
    if (*job_count == batch->job_count() && open == batch->open()) return batch;
    batch->set_job_count(static_cast<int>(*job_count));
    batch->set_open(open);
    absl::Status status = store_->batches().SetJobs(batch_id, *job_count, open);
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  TellOfWork();
  TellOfBatch(batch_id);
  return batch;
}

// The number of jobs that the batch then has.
absl::StatusOr<int64_t> SqliteWorkQueue::AddNewJobs(const v1::Batch& batch, std::span<const v1::Job> jobs) {
  v1::Batch grown = batch;
  for (const v1::Job& job : jobs) {
    if (job.batch_index() < grown.job_count()) {
      const absl::StatusOr<v1::Job> known = store_->jobs().Get(job.id());
      if (!known.ok()) return known.status();
      if (runtime::CanonicalBytes(known->spec()) == runtime::CanonicalBytes(job.spec())) continue;
      return absl::AlreadyExistsError(fmt::format("specs: place {} of batch {} has another spec; make another batch",
                                                  job.batch_index(), batch.id()));
    }
    absl::Status status = CheckPlace(job, grown);
    if (status.ok()) status = store_->jobs().Insert(job, "");
    if (!status.ok()) return status;
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
  absl::Status status = store_->events().Append(event);
  if (status.ok() && !job.batch_id().empty()) status = store_->batches().AddEnd(job.batch_id(), job.id());
  return status;
}

absl::StatusOr<bool> SqliteWorkQueue::EndWaitingJob(const std::string& job_id, const std::string& batch_id,
                                                    absl::Time time) {
  const absl::StatusOr<bool> ended = store_->jobs().CancelWaiting(job_id, time);
  if (!ended.ok() || !*ended) return ended;
  v1::Job job;
  job.set_id(job_id);
  job.set_batch_id(batch_id);
  job.set_state(v1::JOB_STATE_CANCELLED);
  if (absl::Status status = AppendEnded(job); !status.ok()) return status;
  return true;
}

absl::Status SqliteWorkQueue::Cancel(const std::string& job_id, absl::Time now) {
  {
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const absl::StatusOr<v1::Job> job = store_->jobs().Get(job_id);
    if (!job.ok()) return job.status();
    if (job->state() != v1::JOB_STATE_QUEUED && job->state() != v1::JOB_STATE_RUNNING) return absl::OkStatus();
    const absl::StatusOr<bool> ended = EndWaitingJob(job_id, job->batch_id(), now);
    absl::Status status = ended.status();
    if (status.ok() && !*ended) status = store_->jobs().RequestCancel(job_id);
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  CancelHeld(job_id);
  Tell(job_id);
  TellOfBatch("");
  return absl::OkStatus();
}

absl::StatusOr<bool> SqliteWorkQueue::Retry(const std::string& job_id) {
  {
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const absl::StatusOr<v1::Job> job = store_->jobs().Get(job_id);
    if (!job.ok()) return job.status();
    if (!job->batch_id().empty()) {
      const absl::StatusOr<v1::Batch> batch = store_->batches().Get(job->batch_id());
      if (!batch.ok()) return batch.status();
      if (batch->state() == v1::BATCH_STATE_CANCELLED) return false;
    }
    const absl::StatusOr<bool> waits = store_->jobs().Retry(job_id);
    if (!waits.ok() || !*waits) return waits;
    v1::JobEvent event;
    event.set_job_id(job_id);
    event.set_kind(v1::JOB_EVENT_KIND_RETRIED);
    event.set_state(v1::JOB_STATE_QUEUED);
    absl::Status status = store_->events().Append(event);
    if (status.ok()) status = store_->batches().RemoveEnd(job_id);
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  Tell(job_id);
  TellOfWork();
  return true;
}

absl::Status SqliteWorkQueue::SetBatchState(const std::string& batch_id, v1::BatchState state) {
  {
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const absl::StatusOr<v1::Batch> batch = store_->batches().Get(batch_id);
    if (!batch.ok()) return batch.status();
    if (batch->state() == v1::BATCH_STATE_CANCELLED) {
      if (state != v1::BATCH_STATE_ACTIVE) return absl::OkStatus();
      return absl::FailedPreconditionError(fmt::format("batch_id: {} is cancelled; make another batch", batch_id));
    }
    absl::Status status = store_->batches().SetState(batch_id, state);
    if (status.ok()) status = transaction->Commit();
    if (!status.ok()) return status;
  }
  TellOfWork();
  return absl::OkStatus();
}

absl::Status SqliteWorkQueue::CloseForEver(const std::string& batch_id) {
  auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
  if (!transaction.ok()) return transaction.status();
  const absl::StatusOr<v1::Batch> batch = store_->batches().Get(batch_id);
  if (!batch.ok()) return batch.status();
  absl::Status status = store_->batches().SetState(batch_id, v1::BATCH_STATE_CANCELLED);
  if (status.ok()) status = store_->batches().SetJobs(batch_id, batch->job_count(), false);
  if (status.ok()) status = store_->jobs().RequestCancelOfBatch(batch_id);
  if (status.ok()) status = transaction->Commit();
  return status;
}

absl::Status SqliteWorkQueue::CancelBatch(const std::string& batch_id, absl::Time now) {
  // First nobody takes its jobs any more; then those that wait are ended, as many at once as others can wait for.
  absl::Status status = CloseForEver(batch_id);
  for (bool more = true; status.ok() && more;) {
    auto transaction = Transaction::Begin(store_->database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const auto ids = store_->jobs().IdsOf(batch_id, v1::JOB_STATE_QUEUED, kCancelledAtOnce);
    if (!ids.ok()) return ids.status();
    for (const std::string& id : *ids) {
      if (status.ok()) status = EndWaitingJob(id, batch_id, now).status();
    }
    if (status.ok()) status = transaction->Commit();
    more = static_cast<int>(ids->size()) == kCancelledAtOnce;
  }
  if (!status.ok()) return status;
  HonourCancelRequests();
  Tell("");
  TellOfBatch(batch_id);
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
