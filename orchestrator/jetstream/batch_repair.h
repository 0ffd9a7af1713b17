// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/batch_repair.h"
#include "orchestrator/jetstream/consumers.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/job_record.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Sees to it that batches come to their end even when a process died between two steps: jobs of cancelled ones are
// ended, jobs whose message or end is missing get it, and a batch whose jobs have all ended takes nothing of the
// servers any more but its records. Everything here may be done by several processes at once and again. Thread-safe.
class BatchRepair {
 public:
  BatchRepair(QueueParts& parts, JobEnds& ends, Consumers& consumers)
      : parts_(parts), ends_(ends), consumers_(consumers) {}

  // Ends the jobs of a cancelled batch that wait, asks for the end of those that run.
  absl::Status CancelJobs(const std::string& batch_id, int64_t job_count, absl::Time now) {
    const absl::Status status =
        VisitJobs(batch_id, job_count, [&](std::vector<RevisedJob> jobs) { return CancelThese(std::move(jobs), now); });
    return status;
  }

  // Removes the consumer of a batch that has come to its end. When it has not, although it is closed and nothing of it
  // is in the queue stream (`waits`: something is), repairs what is missing. Returns whether to look again without
  // being asked to: at a cancelled one, whose running jobs have yet to end.
  absl::StatusOr<bool> Close(const std::string& batch_id, bool waits) {
    const absl::StatusOr<RevisedBatch> record = parts_.GetBatch(batch_id);
    if (absl::IsNotFound(record.status())) return false;
    if (!record.ok()) return record.status();
    const v1::Batch& batch = record->value.batch();
    const bool cancelled = batch.state() == v1::BATCH_STATE_CANCELLED;
    // Who adds to an open one repeats what was not answered.
    if (batch.open() || (waits && !cancelled)) return false;
    // Taken first: what comes later is of a job that was retried.
    ASSIGN_OR_RETURN(const uint64_t last, parts_.streams.LastSequence(parts_.names.queue_stream()));
    ASSIGN_OR_RETURN(const int64_t ended, ends_.CountAll(batch));
    if (ended >= batch.job_count()) {
      const std::string subject = parts_.names.Batch(OwnerToken(batch.owner()), batch_id);
      RETURN_IF_ERROR(consumers_.Remove(consumers_.ConsumerOf(subject), last));
      return false;
    }
    if (waits) return true;
    if (cancelled) {
      RETURN_IF_ERROR(CancelJobs(batch_id, batch.job_count(), parts_.clock.Now()));
    }
    RETURN_IF_ERROR(VisitJobs(batch_id, batch.job_count(),
                              [this](const std::vector<RevisedJob>& jobs) { return RepairThese(jobs); }));
    return cancelled;
  }

 private:
  // Records in memory at once.
  static constexpr int64_t kVisitedAtOnce = 500;

  using Visit = std::function<absl::Status(std::vector<RevisedJob> jobs)>;

  absl::Status VisitJobs(const std::string& batch_id, int64_t job_count, const Visit& visit) {
    for (int64_t first = 0; first < job_count; first += kVisitedAtOnce) {
      std::vector<std::string> ids;
      for (int64_t i = first; i < std::min(job_count, first + kVisitedAtOnce); ++i) {
        ids.push_back(BatchJobId(batch_id, i));
      }
      const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_.jobs.GetAll(ids);
      std::vector<RevisedJob> jobs;
      for (size_t i = 0; i < ids.size(); ++i) {
        ASSIGN_OR_RETURN(RevisedJob job, parts_.ParseJob(ids[i], entries[i]));
        jobs.push_back(std::move(job));
      }
      RETURN_IF_ERROR(visit(std::move(jobs)));
    }
    return absl::OkStatus();
  }

  absl::Status CancelThese(std::vector<RevisedJob> jobs, absl::Time now) {
    // Again for those that somebody else changed meanwhile.
    while (!jobs.empty()) {
      std::erase_if(jobs, [](const RevisedJob& job) { return HasEnded(job.value) || job.value.cancel_requested(); });
      std::vector<Bucket::Change> changes;
      for (RevisedJob& job : jobs) {
        const bool waits = job.value.job().state() == v1::JOB_STATE_QUEUED;
        job.value.set_cancel_requested(true);
        if (waits) EndJob(job.value, CancelledEnd(now));
        changes.push_back({job.value.job().id(), runtime::CanonicalBytes(job.value), job.revision});
      }
      const std::vector<absl::StatusOr<uint64_t>> revisions = parts_.jobs.UpdateAll(changes);
      std::vector<v1::Job> ended;
      std::vector<RevisedJob> again;
      for (size_t i = 0; i < jobs.size(); ++i) {
        if (absl::IsAborted(revisions[i].status())) {
          ASSIGN_OR_RETURN(RevisedJob job, parts_.GetJob(jobs[i].value.job().id()));
          again.push_back(std::move(job));
          continue;
        }
        if (!revisions[i].ok()) return revisions[i].status();
        if (HasEnded(jobs[i].value)) {
          ended.push_back(jobs[i].value.job());
        } else {
          parts_.Notify(Notice::Kind::kHold, jobs[i].value.job().id());
        }
      }
      RETURN_IF_ERROR(ends_.Publish(ended));
      for (const v1::Job& job : ended) parts_.NotifyJob(job);
      jobs = std::move(again);
    }
    return absl::OkStatus();
  }

  absl::Status RepairThese(const std::vector<RevisedJob>& jobs) {
    std::vector<v1::Job> ended;
    std::vector<NatsRequest> missing;
    for (const RevisedJob& job : jobs) {
      if (HasEnded(job.value)) {
        ended.push_back(job.value.job());
      } else {
        missing.push_back(
            parts_.QueueMessage(job.value.job(), fmt::format("{}-again-{}", job.value.job().id(), job.revision)));
      }
    }
    RETURN_IF_ERROR(ends_.Publish(ended));
    RETURN_IF_ERROR(parts_.streams.PublishEach(missing));
    if (!missing.empty()) parts_.Notify(Notice::Kind::kWork, missing.front().subject);
    return absl::OkStatus();
  }

  QueueParts& parts_;
  JobEnds& ends_;
  Consumers& consumers_;
};

}  // namespace flair::orchestrator
