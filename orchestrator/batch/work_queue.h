// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/lease.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Which jobs or batches to list: the newest first.
struct ListFilter {
  int limit = 50;
  // Only ids below this one; all when empty.
  std::string before;
  // Only those of this owner; all when unset.
  std::optional<std::string> owner;
  // Of jobs only: those of one batch, those in one state.
  std::string batch_id;
  v1::JobState state = v1::JOB_STATE_UNSPECIFIED;
};

// Which jobs to take.
struct TakeFilter {
  // Any that waits. Otherwise those named below.
  bool any = true;
  std::set<std::string> job_ids;
  std::set<std::string> batch_ids;
};

// What a request made.
enum class RequestKind { kJob, kBatch };

// A job of a batch that ended. Sequences grow from end to end, with gaps.
struct BatchEnd {
  int64_t sequence = 0;
  std::string job_id;
};

// What one step of a deletion did.
struct Deleted {
  int64_t job_count = 0;
  int64_t artifact_count = 0;
  // Nothing is left of what was to be deleted.
  bool done = false;
};

// Jobs without a batch, and batches, that ended long ago.
struct EndedPage {
  std::vector<std::string> job_ids;
  std::vector<std::string> batch_ids;
  // Where the next page begins; empty when this was the last.
  std::string next;
};

// Nothing instead of NOT_FOUND.
template <typename T>
absl::StatusOr<std::optional<T>> IfFound(absl::StatusOr<T> result) {
  if (absl::IsNotFound(result.status())) return std::optional<T>();
  RETURN_IF_ERROR(result.status());
  return std::optional<T>(*std::move(result));
}

// NOT_FOUND: what a run is told that found or stored an artifact which was then deleted with the last job that had it.
absl::Status ArtifactIsGone(const std::string& artifact_id);
bool IsArtifactGone(const absl::Status& status);

// Jobs that wait, run and have ended; batches of them; and what stages made before. All of it outlives processes, and
// any number of processes may use one queue: each job is run by one of them at a time and ends once. A job whose
// process dies waits again. Two forms: SqliteWorkQueue (a folder; the processes of one machine) and JetStreamWorkQueue
// (NATS servers; any machine); tests/contract puts the same promises to both. Thread-safe. Every method may wait for
// the store. UNAVAILABLE: the store cannot be reached now; RESOURCE_EXHAUSTED: it is full.
class WorkQueue {
 public:
  // Called from any thread, possibly often and for nothing; must be quick, and not call the queue.
  struct Listener {
    // There may be a job to take.
    std::function<void()> work = [] {};
    // Something happened to the job; to any, when empty.
    std::function<void(const std::string& job_id)> changed = [](const std::string&) {};
    // A job of the batch ended, or the batch itself was changed; any, when empty.
    std::function<void(const std::string& batch_id)> batch_changed = [](const std::string&) {};
  };

  virtual ~WorkQueue() = default;

  // Tells `listener` from now on, instead of who was told before. Returns when no earlier listener is being called.
  virtual void Listen(Listener listener) = 0;

  // ---- Asking for work

  // Queues the job. When the request made one before, returns that one instead.
  virtual absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id) = 0;

  // Makes a batch without jobs. When the request made one before, returns that one instead.
  virtual absl::StatusOr<store::v1::BatchRecord> CreateBatch(const store::v1::BatchRecord& batch) = 0;

  // Whether a request of the owner has made one: CreateJob or CreateBatch would return it.
  virtual absl::StatusOr<bool> HasRequest(RequestKind kind, const std::string& owner,
                                          const std::string& request_id) = 0;

  // Queues jobs of an open batch, with ids of BatchJobId() and consecutive places; with `last`, closes it. Those that
  // are there stay as they are. Errors as OrchestratorService.AddToBatch. The batch without counts by state.
  virtual absl::StatusOr<v1::Batch> AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs, bool last) = 0;

  // Asks for the end of a job; one that waits ends at once. Nothing changes when it has ended. NOT_FOUND when unknown.
  virtual absl::Status Cancel(const std::string& job_id, absl::Time now) = 0;

  // Lets a FAILED job wait again, with the artifacts it has. False when it is not FAILED, or its batch is cancelled.
  virtual absl::StatusOr<bool> Retry(const std::string& job_id) = 0;

  // Pauses the batch or lets it go on. Nothing changes for one that is cancelled (FAILED_PRECONDITION when ACTIVE).
  virtual absl::Status SetBatchState(const std::string& batch_id, v1::BatchState state) = 0;

  // Closes the batch for ever and asks for the end of its jobs.
  virtual absl::Status CancelBatch(const std::string& batch_id, absl::Time now) = 0;

  // ---- Deleting it. `artifacts` is where the jobs' artifacts are; those that no other job has are deleted. A process
  // that is killed in between leaves nothing half deleted in sight; called again, or by FinishDeletions, it goes on.

  // Forgets a job without a batch that has ended; its request may make another one. NOT_FOUND when unknown,
  // FAILED_PRECONDITION as CheckDeletable (job_rules.h).
  virtual absl::StatusOr<Deleted> DeleteJob(const std::string& job_id, ArtifactStore& artifacts) = 0;

  // Forgets at most about `job_limit` jobs of a batch that has ended, those at the last places first, and with the last
  // of them the batch. What is left in between is a cancelled batch. Errors as DeleteJob.
  virtual absl::StatusOr<Deleted> DeleteBatch(const std::string& batch_id, int job_limit, ArtifactStore& artifacts) = 0;

  // Ends what a process that died had begun to delete; but batches, which still are there.
  virtual absl::StatusOr<Deleted> FinishDeletions(ArtifactStore& artifacts) = 0;

  // Jobs without a batch that ended before `time`, and batches that came to their end before it. A page of them: looks
  // at `limit` or so, from where an earlier page said that the next begins; the first one when `after` is empty.
  virtual absl::StatusOr<EndedPage> EndedBefore(absl::Time time, const std::string& after, int limit) = 0;

  // ---- Doing it

  // The right to run the next job: those without a batch first, oldest first, then a job of each batch that is active
  // in turn, about in the order of their places. Null when none waits. Its attempt_count says how often it has been
  // taken.
  virtual absl::StatusOr<std::unique_ptr<Lease>> Take(const TakeFilter& filter) = 0;

  // What a stage made before under a key of ResultKey(); nothing when nothing was made.
  virtual absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key) = 0;

  // ---- What is known

  // NOT_FOUND when unknown.
  virtual absl::StatusOr<v1::Job> GetJob(const std::string& job_id) = 0;
  virtual absl::StatusOr<std::vector<v1::Job>> ListJobs(const ListFilter& filter) = 0;

  // At most `limit` events after a sequence number, in order. Empty for an unknown job.
  virtual absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence,
                                                                int limit) = 0;

  // With counts. NOT_FOUND when unknown.
  virtual absl::StatusOr<v1::Batch> GetBatch(const std::string& batch_id) = 0;
  // Without counts by state, so cheap for any size.
  virtual absl::StatusOr<v1::Batch> FindBatch(const std::string& batch_id) = 0;
  virtual absl::StatusOr<std::vector<v1::Batch>> ListBatches(const ListFilter& filter) = 0;

  // Whether the batch is closed and no job of it waits or runs; asked for after every end, so cheap for any size.
  // NOT_FOUND when unknown.
  virtual absl::StatusOr<bool> BatchHasEnded(const std::string& batch_id) = 0;

  // Ends of a batch's jobs after a sequence number, in order, at most `limit`. Of a job that was retried, the latest.
  virtual absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit) = 0;

  // Jobs that wait; and, of one owner, that wait or run.
  virtual absl::StatusOr<int64_t> CountQueued() = 0;
  virtual absl::StatusOr<int64_t> CountOpen(const std::string& owner) = 0;

  // Whether one of the owner's jobs has the artifact.
  virtual absl::StatusOr<bool> OwnsArtifact(const std::string& owner, const std::string& artifact_id) = 0;

  // ---- Who works

  // Tells the others of this process. Forgotten some seconds after the last report.
  virtual absl::Status ReportStatus(const v1::OrchestratorStatus& status) = 0;
  virtual absl::StatusOr<std::vector<v1::OrchestratorStatus>> Orchestrators() = 0;
};

// Makes ids that sort by age: time of day in UTC with microseconds, then random digits against other processes, such as
// "20260521T134501123456-3fa2c1". Later ids of one process are larger even when its clock stands still. Thread-safe.
class JobIdSource {
 public:
  explicit JobIdSource(const runtime::Clock& clock) : clock_(clock) {}
  std::string Next();

 private:
  const runtime::Clock& clock_;
  std::mutex mutex_;
  std::random_device random_;
  absl::Time last_ = absl::InfinitePast();
};

// Id of the job at a place of a batch: sorts by place.
std::string BatchJobId(const std::string& batch_id, int64_t index);

}  // namespace flair::orchestrator
