// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/consumers.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Completes batches even if a process died between two steps: ends the jobs of cancelled batches, restores missing
// messages and ends, and removes everything but the records of a batch whose jobs have all ended. Several processes may
// do all of this at the same time and repeatedly. Thread-safe.
class BatchRepair {
 public:
  BatchRepair(QueueParts& parts, JobEnds& ends, Consumers& consumers)
      : parts_(parts), ends_(ends), consumers_(consumers) {}

  // Ends a job that waits, asks for the end of one that runs.
  absl::Status CancelJob(const std::string& job_id, absl::Time now) {
    bool changed = false;
    const auto cancel = [&](store::v1::JobRecord& record) { return changed = orchestrator::CancelJob(record, now); };
    ASSIGN_OR_RETURN(const RevisedJob job, parts_.ChangeJob(job_id, cancel));
    // Somebody may take back an end that was there before, to run the job again.
    if (!changed && HasEnded(job.value)) return absl::OkStatus();
    return Announce(std::span(&job, 1));
  }

  // The same for all jobs of a cancelled batch.
  absl::Status CancelJobs(const std::string& batch_id, int64_t job_count, absl::Time now) {
    return VisitJobs(batch_id, job_count,
                     [&](std::vector<RevisedJob> jobs) { return CancelThese(std::move(jobs), now); });
  }

  // Removes the consumer of a batch that has ended. Repairs one that is closed and has no messages in the queue stream
  // (`waits`: it has some) but has not ended. Returns whether to check again unasked: a cancelled one, whose running
  // jobs have not ended yet.
  absl::StatusOr<bool> Close(const std::string& batch_id, bool waits) {
    ASSIGN_OR_RETURN(const std::optional<RevisedBatch> record, IfFound(parts_.GetBatch(batch_id)));
    if (!record.has_value()) return false;
    const v1::Batch& batch = record->value.batch();
    const bool cancelled = batch.state() == v1::BATCH_STATE_CANCELLED;
    // The caller that adds to an open one repeats what was not answered.
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
    std::erase_if(jobs, [now](RevisedJob& job) { return !orchestrator::CancelJob(job.value, now); });
    std::vector<Bucket::Change> changes;
    for (const RevisedJob& job : jobs) {
      changes.push_back({job.value.job().id(), runtime::CanonicalBytes(job.value), job.revision});
    }
    const std::vector<absl::StatusOr<uint64_t>> revisions = parts_.jobs.UpdateAll(changes);
    std::vector<RevisedJob> changed;
    for (size_t i = 0; i < jobs.size(); ++i) {
      if (absl::IsAborted(revisions[i].status())) {
        // Somebody else changed it meanwhile.
        RETURN_IF_ERROR(CancelJob(changes[i].key, now));
        continue;
      }
      RETURN_IF_ERROR(revisions[i].status());
      changed.push_back(std::move(jobs[i]));
    }
    return Announce(changed);
  }

  // Tells the others of jobs that were cancelled. The messages of those that waited stay until they are delivered to
  // somebody.
  absl::Status Announce(std::span<const RevisedJob> cancelled) {
    std::vector<v1::Job> ended;
    for (const RevisedJob& job : cancelled) {
      if (HasEnded(job.value)) ended.push_back(job.value.job());
    }
    const absl::Status published = ends_.Publish(ended);
    for (const v1::Job& job : ended) parts_.NotifyJob(job);
    for (const RevisedJob& job : cancelled) {
      if (!HasEnded(job.value)) parts_.Notify(Notice::Kind::kHold, job.value.job().id());
    }
    return published;
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
