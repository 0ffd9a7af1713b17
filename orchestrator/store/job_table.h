// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/store/database.h"

namespace flair::orchestrator {

// One run of a job: who runs it, and the how manyth run it is. Writes for a run that has been superseded do not match
// any more.
struct JobHold {
  std::string job_id;
  std::string owner;
  int attempt = 0;
};

// Queries about jobs, their events and artifacts, and what stages made before. Each call is one step for other
// processes; to join several, hold a Transaction. A Job read here has its artifacts too. Thread-safe.
class JobTable {
 public:
  explicit JobTable(Database& database) : database_(database) {}

  // A new QUEUED job; `request_id` empty for a job of a batch. ALREADY_EXISTS when its id or request id is taken.
  absl::Status Insert(const v1::Job& job, const std::string& request_id);

  // NOT_FOUND when unknown.
  absl::StatusOr<v1::Job> Get(const std::string& id);

  // Id of the job that a request made; empty when none.
  absl::StatusOr<std::string> FindByRequest(const std::string& request_id);

  absl::StatusOr<std::vector<v1::Job>> List(const ListFilter& filter);

  // Ids of at most `limit` jobs of a batch in a state.
  absl::StatusOr<std::vector<std::string>> IdsOf(const std::string& batch_id, v1::JobState state, int limit);

  absl::StatusOr<int64_t> CountQueued();
  // QUEUED and RUNNING ones of one caller.
  absl::StatusOr<int64_t> CountOpen(const std::string& caller);
  // `caller` is not empty.
  absl::StatusOr<bool> OwnsArtifact(const std::string& caller, const std::string& artifact_id);

  // The oldest QUEUED job of a batch ("": of none) that may run by `now`; empty when none.
  absl::StatusOr<std::string> OldestWaiting(const std::string& batch_id, absl::Time now);
  // The least id above `after` of a batch with QUEUED jobs; empty when none.
  absl::StatusOr<std::string> NextBatchWaiting(const std::string& after);
  // Whether a job waited for a time that has come by `now`.
  absl::StatusOr<bool> AnyDelayPassed(absl::Time now);

  // Makes a QUEUED job RUNNING by `owner` in a new run; false when it is not QUEUED.
  absl::StatusOr<bool> Claim(const std::string& id, const std::string& owner);

  // Owners of RUNNING jobs.
  absl::StatusOr<std::vector<std::string>> Owners();

  // Makes the RUNNING jobs of a dead owner QUEUED again.
  absl::Status Release(const std::string& owner);

  // Consecutive runs before the one that goes on whose process died and that stored nothing.
  absl::StatusOr<int64_t> LostRunCount(const std::string& id);

  // For the run that holds a RUNNING job; false, and nothing done, when another one does or none: its stage; QUEUED
  // again, not before some time; ended with job.state(), stage, error, failure_kind and end_time.
  absl::StatusOr<bool> SetStage(const JobHold& hold, const std::string& stage, bool made_something);
  absl::StatusOr<bool> Requeue(const JobHold& hold, absl::Time not_before);
  absl::StatusOr<bool> End(const JobHold& hold, const v1::Job& job);

  // Ends a QUEUED job as CANCELLED; false when it is not QUEUED.
  absl::StatusOr<bool> CancelWaiting(const std::string& id, absl::Time time);

  // Makes a FAILED job QUEUED again; false when it is not FAILED.
  absl::StatusOr<bool> Retry(const std::string& id);

  // Remembers that a job, or all RUNNING ones of a batch, are to be cancelled.
  absl::Status RequestCancel(const std::string& id);
  absl::Status RequestCancelOfBatch(const std::string& batch_id);
  absl::StatusOr<bool> CancelRequested(const std::string& id);

  // Stores an event under the job's next sequence number.
  absl::Status AppendEvent(v1::JobEvent event);
  // At most `limit` events after a sequence number, in order.
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence, int limit);

  // The artifacts of a job, in stage order; a stage's new artifact replaces its old one.
  absl::StatusOr<std::vector<v1::ArtifactRef>> ArtifactsOf(const std::string& job_id);
  absl::Status Attach(const std::string& job_id, int stage_index, const v1::ArtifactRef& artifact);

  // What was made under a key of ResultKey(); nothing when nothing was. The latest result wins.
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key);
  absl::Status SetResult(const std::string& key, const v1::ArtifactRef& artifact);

 private:
  absl::StatusOr<v1::Job> Read(const Statement& row);
  template <typename... Values>
  absl::StatusOr<bool> ChangesOne(std::string_view sql, const Values&... values);

  Database& database_;
};

}  // namespace flair::orchestrator
