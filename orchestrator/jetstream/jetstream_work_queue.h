// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/repeater.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/artifact_users.h"
#include "orchestrator/jetstream/consumers.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/lease_keeper.h"
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
    if (cancelled) RETURN_IF_ERROR(CancelJobs(batch_id, batch.job_count(), parts_.clock.Now()));
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

// The queue on NATS servers; see docs/decisions/0017-jobs-wait-in-jetstream.md for how, and queue_parts.h for what is
// where. Two threads of its own besides the keeper's: one reads notices, one looks every second, since notices may be
// lost.
class JetStreamWorkQueue final : public WorkQueue {
 public:
  static absl::StatusOr<std::unique_ptr<WorkQueue>> Open(std::unique_ptr<QueueParts> parts);
  ~JetStreamWorkQueue() override;

  void Listen(Listener listener) override;

  absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id,
                                    const GivenArtifact* given) override;
  absl::StatusOr<store::v1::BatchRecord> CreateBatch(const store::v1::BatchRecord& batch) override;
  absl::StatusOr<bool> HasRequest(RequestKind kind, const std::string& owner, const std::string& request_id) override;
  absl::StatusOr<v1::Batch> AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs, bool last) override;
  absl::Status Cancel(const std::string& job_id, absl::Time now) override;
  absl::StatusOr<bool> Retry(const std::string& job_id) override;
  absl::Status SetBatchState(const std::string& batch_id, v1::BatchState state) override;
  absl::Status CancelBatch(const std::string& batch_id, absl::Time now) override;

  absl::StatusOr<Deleted> DeleteJob(const std::string& job_id, ArtifactStore& artifacts) override;
  absl::StatusOr<Deleted> DeleteBatch(const std::string& batch_id, int job_limit, ArtifactStore& artifacts) override;
  absl::StatusOr<Deleted> FinishDeletions(ArtifactStore& artifacts) override;
  absl::StatusOr<EndedPage> EndedBefore(absl::Time time, const std::string& after, int limit) override;

  absl::StatusOr<std::unique_ptr<Lease>> Take(const TakeFilter& filter) override;
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key) override;

  absl::StatusOr<v1::Job> GetJob(const std::string& job_id) override;
  absl::StatusOr<std::vector<v1::Job>> ListJobs(const ListFilter& filter) override;
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence,
                                                        int limit) override;
  absl::StatusOr<v1::Batch> GetBatch(const std::string& batch_id) override;
  absl::StatusOr<v1::Batch> FindBatch(const std::string& batch_id) override;
  absl::StatusOr<std::vector<v1::Batch>> ListBatches(const ListFilter& filter) override;
  absl::StatusOr<bool> BatchHasEnded(const std::string& batch_id) override;
  absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit) override;
  absl::StatusOr<int64_t> CountQueued() override;
  absl::StatusOr<int64_t> CountOpen(const std::string& owner) override;
  absl::StatusOr<bool> OwnsArtifact(const std::string& owner, const std::string& artifact_id) override;

  absl::Status ReportStatus(const v1::OrchestratorStatus& status) override;
  absl::StatusOr<std::vector<v1::OrchestratorStatus>> Orchestrators() override;

 private:
  explicit JetStreamWorkQueue(std::unique_ptr<QueueParts> parts);
  absl::Status Start();

  // requests.cc
  absl::StatusOr<std::string> IdOfRequest(const std::string& key, const std::string& id);
  absl::Status Give(const GivenArtifact& given, const v1::Job& job);
  absl::Status AddRecords(const std::string& batch_id, std::span<const v1::Job> jobs);
  absl::Status CompareSpecs(std::span<const v1::Job> jobs);
  absl::Status PutIntoQueue(std::span<const v1::Job> jobs);

  // delete.cc
  std::string NoteKey(const std::string& owner, const std::string& id) const;
  absl::Status RemoveNote(const std::string& owner, const std::string& id);
  absl::Status RemoveRequest(const std::string& key, const std::string& id);
  absl::StatusOr<int64_t> DeleteArtifacts(std::span<const std::string> ids, const std::string& user_id,
                                          ArtifactStore& artifacts);
  absl::StatusOr<Deleted> ForgetJob(const std::string& job_id, const std::string& owner, ArtifactStore& artifacts);
  absl::StatusOr<RevisedBatch> BeginToDelete(const std::string& batch_id);
  absl::StatusOr<int64_t> ForgetPlaces(const std::string& batch_id, int64_t first, int64_t end);
  absl::Status DeleteTombstoned(const std::string& batch_id, int64_t all, int64_t job_limit, ArtifactStore& artifacts,
                                Deleted& deleted);
  absl::Status ForgetBatch(const store::v1::BatchRecord& record);

  // list.cc
  absl::StatusOr<bool> BatchEndedBefore(absl::Time time, const std::string& batch_id);

  // take.cc
  absl::StatusOr<std::unique_ptr<Lease>> TakeFrom(const Consumer& consumer, int& passed_over);
  absl::StatusOr<std::unique_ptr<Lease>> Begin(const Consumer& consumer, const Delivery& delivery,
                                               bool batch_cancelled);
  absl::StatusOr<bool> MayRun(const Delivery& delivery, const store::v1::JobRecord& record, bool batch_cancelled);
  absl::StatusOr<bool> OtherMessageRuns(const Delivery& delivery, const store::v1::JobRecord& record);
  absl::StatusOr<v1::BatchState> BatchStateOf(const Consumer& consumer);
  absl::Status WantNamed(const std::set<std::string>& job_ids);
  void Acknowledge(const Delivery& delivery, const std::string& how);

  // list.cc
  absl::StatusOr<std::vector<v1::Job>> ListOfBatch(const ListFilter& filter);
  absl::StatusOr<std::vector<v1::Job>> GetJobs(std::span<const std::string> ids, const ListFilter& filter);

  absl::Status VisitRequests(const ListFilter& filter, const std::string& kind, const std::function<bool()>& more,
                             const std::function<absl::Status(const std::string& kind, const std::string& id)>& visit);

  // watch.cc
  void ReadNotices();
  absl::Duration Look();
  void LookOnce();
  void NotifyListenerOfWork();
  void NotifyListenerOfJob(const std::string& job_id);
  void NotifyListenerOfBatch(const std::string& batch_id);
  void ScheduleRepair(const std::string& batch_id);
  void Queued(const std::string& consumer);

  const std::unique_ptr<QueueParts> parts_;
  // Unique among the processes of a queue.
  const std::string process_;
  JobEnds ends_;
  Consumers consumers_;
  BatchRepair repair_;
  ArtifactUsers users_;
  LeaseKeeper keeper_;
  std::atomic<int64_t> next_run_ = 1;

  std::mutex listener_mutex_;
  Listener listener_;

  std::mutex repair_mutex_;
  // Batches to be looked at.
  std::set<std::string> to_repair_;
  std::unique_ptr<NatsInbox> notices_;
  std::thread notice_thread_;
  // Of the thread that looks.
  int looks_ = 0;
  int64_t reconnects_ = 0;
  std::optional<Repeater> looker_;
};

}  // namespace flair::orchestrator
