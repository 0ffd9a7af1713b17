// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/batch/job_id.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/store/job_store.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// Answers the RPCs of OrchestratorService but WatchJob, as its comments say. Knows nothing of gRPC. Thread-safe. The
// arguments outlive it.
class OrchestratorHandlers {
 public:
  OrchestratorHandlers(JobStore& store, JobRunner& runner, const runtime::Clock& clock, int queued_job_limit)
      : store_(store), runner_(runner), clock_(clock), queued_job_limit_(queued_job_limit), ids_(clock) {}

  using Call = runtime::CallContext;
  absl::StatusOr<v1::CreateJobResponse> CreateJob(const v1::CreateJobRequest& request, Call& call);
  absl::StatusOr<v1::GetJobResponse> GetJob(const v1::GetJobRequest& request, Call& call);
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request, Call& call);
  absl::StatusOr<v1::CancelJobResponse> CancelJob(const v1::CancelJobRequest& request, Call& call);
  absl::StatusOr<v1::CreateBatchResponse> CreateBatch(const v1::CreateBatchRequest& request, Call& call);
  absl::StatusOr<v1::GetBatchResponse> GetBatch(const v1::GetBatchRequest& request, Call& call);
  absl::StatusOr<v1::GetArtifactResponse> GetArtifact(const v1::GetArtifactRequest& request, Call& call);

 private:
  v1::Job NewJob(const v1::JobSpec& spec, const std::string& batch_id);
  absl::Status CheckQueue(int64_t job_count);

  JobStore& store_;
  JobRunner& runner_;
  const runtime::Clock& clock_;
  const int queued_job_limit_;
  JobIdSource ids_;
};

}  // namespace flair::orchestrator
