// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/store/v1/job_record.pb.h"
#include "flair/v1/job.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::orchestrator {

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

}  // namespace flair::orchestrator
