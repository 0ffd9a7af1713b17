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
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/store/v1/job_record.pb.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Artifacts by their ids. An artifact is whole or not there; putting one twice is harmless. Several processes, on
// several machines where the form allows, may use one store. Thread-safe.
class ArtifactStore {
 public:
  virtual ~ArtifactStore() = default;

  // Stores those of which no good copy is there already; others count as stored anew. They survive the end of any
  // process. RESOURCE_EXHAUSTED when there is no room, UNAVAILABLE when the store cannot be reached; then some of them
  // may be there.
  virtual absl::Status PutAll(std::span<const SealedArtifact> artifacts) = 0;

  // Gives one artifact its id, stores it and names it.
  absl::StatusOr<v1::ArtifactRef> Put(v1::Artifact& artifact) {
    SealedArtifact sealed = SealArtifact(artifact);
    RETURN_IF_ERROR(PutAll(std::span(&sealed, 1)));
    return std::move(sealed.ref);
  }

  // NOT_FOUND when there is none, DATA_LOSS when what is stored does not have that id, INVALID_ARGUMENT when `id` is no
  // id, UNAVAILABLE when the store cannot be reached.
  virtual absl::StatusOr<v1::Artifact> Get(const std::string& id) = 0;

  // Returns when these survive a loss of power too, as far as the store's machines go. Those that are gone are left
  // out: who needs them finds out by Get.
  virtual absl::Status Flush(std::span<const v1::ArtifactRef> artifacts) = 0;

  // A mark in the order in which artifacts are stored: what is stored from now on comes after it.
  virtual absl::StatusOr<int64_t> Mark() = 0;

  // Deletes those that were last stored before the mark; passes over those that are not there. Returns how many went.
  virtual absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) = 0;
};

// What a stage did, and what is to be remembered of it.
struct StageRecord {
  // With job_id, kind, stage, and what belongs to the kind; the queue gives it its sequence.
  v1::JobEvent event;
  // The stage's place in the job's artifacts, which are kept in that order; a stage's new artifact replaces its old
  // one.
  int stage_index = 0;
  // Under which the event's artifact is found again (WorkQueue::FindResult); empty: under none.
  std::string result_key;
};

// An artifact that a job has from its beginning on, instead of running the stage that would make it.
struct GivenArtifact {
  SealedArtifact artifact;
  StageRecord record;
  // Outlives it.
  ArtifactStore* store = nullptr;
};

// How a job ended.
struct JobEnd {
  v1::JobState state = v1::JOB_STATE_SUCCEEDED;
  // The stage that ended it; empty when none did.
  std::string stage;
  // Of failed jobs.
  absl::Status error;
  v1::FailureKind failure_kind = v1::FAILURE_KIND_UNSPECIFIED;
  absl::Time time;
  // What stages did before it that is not stored yet; stored in the same step.
  std::vector<StageRecord> records = {};
};

// The right to run a job, which one run has at a time: WorkQueue::Take gives it, the queue keeps it alive, and what is
// written under a lease that was lost is refused, so that two runs never mix. Destroyed without End or Return, the job
// waits again at once. The queue outlives it. RecordAll may be called from several threads at once; what is refused
// with ABORTED was not written: another run has the job.
class Lease {
 public:
  explicit Lease(store::v1::JobRecord taken) : taken_(std::move(taken)) {}
  virtual ~Lease() = default;

  // The job's record as it was when taken.
  const store::v1::JobRecord& taken() const { return taken_; }

  // With the artifacts of earlier runs, attempt_count counting this one.
  const v1::Job& job() const { return taken_.job(); }

  // What happened in earlier runs.
  const google::protobuf::RepeatedPtrField<v1::JobEvent>& history() const { return taken_.events(); }

  // Runs just before this one that ended without End or Return, each with its process, and stored no artifact.
  int lost_run_count() const { return taken_.lost_run_count() - 1; }

  // To be called before artifacts of these events are stored: from now on nobody deletes them. Errors as RecordAll,
  // which does the same for those that were left out.
  virtual absl::Status Announce(std::span<const StageRecord> records) = 0;

  // Stores the events, in this order, and all that they stand for, or nothing: the job's stage, artifacts, results.
  // ArtifactIsGone when an artifact may have been deleted with the last other job that had it, since this run stored or
  // found it: the next run makes it again. The same holds for End.
  virtual absl::Status RecordAll(std::span<const StageRecord> records) = 0;
  absl::Status Record(const StageRecord& record) { return RecordAll(std::span(&record, 1)); }

  // Ends the job, once. What was ended is safe against loss of power where the queue's form can be.
  virtual absl::Status End(const JobEnd& end) = 0;

  // Lets the job wait again, at least for `delay`. With a reason, remembers that as an event (WAITING).
  virtual absl::Status Return(absl::Duration delay, const std::string& reason) = 0;

  // Cancelled by the queue when somebody wants the job to end, or when the lease is lost; and by whoever stops the run.
  virtual runtime::Cancellation& cancellation() = 0;

  // Somebody wants the job to end.
  virtual bool cancel_requested() = 0;

  // Another run may have the job.
  virtual bool lost() = 0;

 private:
  const store::v1::JobRecord taken_;
};

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

  // Queues the job. When the request made one before, returns that one instead. With `given`, which may be null, stores
  // that first, so that it is there when somebody takes the job, and as long as there is the job.
  virtual absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id,
                                            const GivenArtifact* given) = 0;
  absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id) {
    return CreateJob(job, request_id, nullptr);
  }

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
