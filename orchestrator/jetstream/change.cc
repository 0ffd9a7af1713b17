// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs and batches are ended, paused, retried.
#include <fmt/format.h>

#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "orchestrator/jetstream/job_record.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

absl::Status JetStreamWorkQueue::Cancel(const std::string& job_id, absl::Time now) {
  bool ended = false;
  const absl::StatusOr<RevisedJob> job =
      parts_->ChangeJob(job_id, [&](store::v1::JobRecord& record) -> absl::StatusOr<bool> {
        ended = false;
        if (HasEnded(record) || record.cancel_requested()) return false;
        record.set_cancel_requested(true);
        ended = record.job().state() == v1::JOB_STATE_QUEUED;
        if (ended) EndJob(record, CancelledEnd(now));
        return true;
      });
  if (!job.ok()) return job.status();
  const v1::Job& changed = job->value.job();
  if (ended) {
    // Its message stays until somebody is handed it.
    RETURN_IF_ERROR(ends_.Publish(std::span(&changed, 1)));
  }
  if (ended) {
    parts_->TellOfJob(changed);
  } else {
    parts_->TellHolder(job_id);
  }
  return absl::OkStatus();
}

absl::StatusOr<bool> JetStreamWorkQueue::Retry(const std::string& job_id) {
  ASSIGN_OR_RETURN(const RevisedJob failed, parts_->GetJob(job_id));
  const v1::Job& job = failed.value.job();
  if (job.state() != v1::JOB_STATE_FAILED) return false;
  if (!job.batch_id().empty()) {
    ASSIGN_OR_RETURN(const RevisedBatch batch, parts_->GetBatch(job.batch_id()));
    if (batch.value.batch().state() == v1::BATCH_STATE_CANCELLED) return false;
  }
  // The end goes first: with it, the batch would seem to have come to its own. Without it, one that is found later is
  // given back; see BatchCare.
  RETURN_IF_ERROR(ends_.Remove(job));
  bool retried = false;
  const absl::StatusOr<RevisedJob> now =
      parts_->ChangeJob(job_id, [&](store::v1::JobRecord& record) -> absl::StatusOr<bool> {
        retried = record.job().state() == v1::JOB_STATE_FAILED;
        if (retried) RetryJob(record);
        return retried;
      });
  if (!now.ok()) return now.status();
  const v1::Job& waiting = now->value.job();
  if (!retried) {
    // Somebody else did, and the end that was removed may have been of the run after that.
    if (!HasEnded(now->value)) return false;
    RETURN_IF_ERROR(ends_.Publish(std::span(&waiting, 1)));
    return false;
  }
  const NatsRequest message = parts_->QueueMessage(waiting, fmt::format("{}-retry-{}", job_id, now->revision));
  RETURN_IF_ERROR(parts_->api.Publish(message).status());
  Queued(message.subject);
  parts_->TellOfJob(waiting);
  return true;
}

absl::Status JetStreamWorkQueue::SetBatchState(const std::string& batch_id, v1::BatchState state) {
  const absl::StatusOr<RevisedBatch> changed =
      parts_->ChangeBatch(batch_id, [&](store::v1::BatchRecord& record) -> absl::StatusOr<bool> {
        v1::Batch& batch = *record.mutable_batch();
        if (batch.state() == v1::BATCH_STATE_CANCELLED) {
          if (state != v1::BATCH_STATE_ACTIVE) return false;
          return absl::FailedPreconditionError(fmt::format("batch_id: {} is cancelled; make another batch", batch_id));
        }
        if (batch.state() == state) return false;
        batch.set_state(state);
        return true;
      });
  if (!changed.ok()) return changed.status();
  parts_->TellOfBatch(batch_id);
  return absl::OkStatus();
}

absl::Status JetStreamWorkQueue::CancelBatch(const std::string& batch_id, absl::Time now) {
  const absl::StatusOr<RevisedBatch> changed =
      parts_->ChangeBatch(batch_id, [](store::v1::BatchRecord& record) -> absl::StatusOr<bool> {
        v1::Batch& batch = *record.mutable_batch();
        if (batch.state() == v1::BATCH_STATE_CANCELLED && !batch.open()) return false;
        batch.set_state(v1::BATCH_STATE_CANCELLED);
        batch.set_open(false);
        return true;
      });
  if (!changed.ok()) return changed.status();
  const absl::Status status = care_.CancelJobs(batch_id, changed->value.batch().job_count(), now);
  // Its messages go when the last of its jobs has ended; see LookOnce.
  CareFor(batch_id);
  parts_->TellOfBatch(batch_id);
  return status;
}

}  // namespace flair::orchestrator
