// SPDX-License-Identifier: GPL-3.0-or-later
// What may happen to jobs and batches, as pure functions of their records. Every form of the queue loads a record, lets
// one of these change it, and stores the result unless somebody else has changed it meanwhile.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// Neither waits nor runs.
bool HasEnded(const v1::Job& job);
inline bool HasEnded(const store::v1::JobRecord& record) { return HasEnded(record.job()); }

// A job that waits for its first run, with what it was given, if anything.
store::v1::JobRecord NewRecord(const v1::Job& job, const std::string& request_id, const GivenArtifact* given = nullptr);

// A run begins; whoever ran it before is out.
void BeginRun(store::v1::JobRecord& record, const std::string& holder);

// Stages of the run did something.
void AddStageRecords(store::v1::JobRecord& record, std::span<const StageRecord> stages);

// The one moment at which the job ends, with what its stages did last.
void EndJob(store::v1::JobRecord& record, const JobEnd& end);

// The end of a job that somebody wanted to end.
JobEnd CancelledEnd(absl::Time time);

// The run ends, the job does not. Remembered as an event when there is a reason.
void ReturnJob(store::v1::JobRecord& record, absl::Time not_before, const std::string& reason);

// Somebody wants the job to end: one that waits ends now. False when that changes nothing.
bool CancelJob(store::v1::JobRecord& record, absl::Time now);

// A failed job waits again. False when it has not failed.
bool RetryJob(store::v1::JobRecord& record);

// Lets an open batch count the jobs that are added to it, and closes it with `last`. False when that changes nothing.
// Errors of WorkQueue::AddJobs, but for those of single jobs.
absl::StatusOr<bool> GrowBatch(std::span<const v1::Job> jobs, bool last, v1::Batch& batch);

// ALREADY_EXISTS when `known`, at the same place of the batch, has another spec.
absl::Status CheckSameSpec(const v1::Job& known, const v1::Job& job);

// Pauses the batch or lets it go on. False when that changes nothing; FAILED_PRECONDITION when a cancelled one is to go
// on.
absl::StatusOr<bool> SetBatchState(v1::BatchState state, v1::Batch& batch);

// Closes the batch for ever; none of its jobs is begun any more. False when that changes nothing.
bool CancelBatch(v1::Batch& batch);

// Sets the counts of a batch but running_count by how many of its jobs ended, how, and in which kind of failure.
using EndCounts = std::map<std::pair<v1::JobState, v1::FailureKind>, int>;
void SetCounts(const EndCounts& ends, v1::Batch& batch);

// FAILED_PRECONDITION when the job waits or runs, or goes only with its batch; when the batch is open or, as `ended`
// says, a job of it waits or runs.
absl::Status CheckDeletable(const v1::Job& job);
absl::Status CheckDeletable(const v1::Batch& batch, bool ended);

// The servers of `config.address`, in its order.
std::vector<std::string> QueueServers(const config::v1::QueueConfig& config);

// The addresses without the user, password or token that they may hold: for people and files.
std::string ShownAddress(const config::v1::QueueConfig& config);

// INVALID_ARGUMENT names the field that is wrong. `tls` is null when the program has no certificates.
absl::Status CheckQueueConfig(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls);

// How a queue and its artifacts on NATS servers are opened; see orchestrator/jetstream/open.h.
struct NatsForms {
  absl::StatusOr<std::unique_ptr<WorkQueue>> (*open_queue)(const config::v1::QueueConfig&, const config::v1::TlsConfig*,
                                                           const runtime::Clock&);
  absl::StatusOr<std::unique_ptr<ArtifactStore>> (*open_artifacts)(const config::v1::QueueConfig&,
                                                                   const config::v1::TlsConfig*, const runtime::Clock&);
};

// Called at a program's start. Without it, Nats() gives functions that return UNIMPLEMENTED, and the program links no
// NATS client: flair-design, which is built first, does without.
void UseNats(const NatsForms& forms);
const NatsForms& Nats();

}  // namespace flair::orchestrator
