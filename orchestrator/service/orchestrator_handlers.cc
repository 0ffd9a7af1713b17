// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/orchestrator_handlers.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <vector>

#include "orchestrator/pipeline/stage.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

v1::Job OrchestratorHandlers::NewJob(const v1::JobSpec& spec) const {
  v1::Job job;
  *job.mutable_spec() = spec;
  job.set_state(v1::JOB_STATE_QUEUED);
  *job.mutable_create_time() =
      google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(clock_.Now()));
  return job;
}

absl::Status OrchestratorHandlers::CheckSpec(const v1::JobSpec& spec, const Caller& caller) {
  if (!spec.has_replay()) return absl::OkStatus();
  const absl::StatusOr<v1::Job> earlier = VisibleJob(spec.replay().job_id(), caller);
  if (!earlier.ok()) {
    return absl::Status(earlier.status().code(),
                        fmt::format("spec.replay.{}", std::string(earlier.status().message())));
  }
  return CheckReplay(spec, *earlier);
}

absl::Status OrchestratorHandlers::UnlessRepeated(const absl::Status& refusal, RequestKind kind,
                                                  const std::string& request_id, const Caller& caller) {
  if (!absl::IsResourceExhausted(refusal)) return refusal;
  const absl::StatusOr<bool> known = queue_.HasRequest(kind, caller.name, caller.RequestKey(request_id));
  return known.ok() && *known ? absl::OkStatus() : refusal;
}

absl::StatusOr<v1::Job> OrchestratorHandlers::VisibleJob(const std::string& id, const Caller& caller) {
  absl::StatusOr<v1::Job> job = queue_.GetJob(id);
  // In the same words, whatever the queue's: nobody can tell another's job from none.
  const bool hidden = job.ok() ? !caller.MaySee(job->owner()) : absl::IsNotFound(job.status());
  if (!hidden) return job;
  return absl::NotFoundError(fmt::format("job_id: no job \"{}\" in this store", id.substr(0, 80)));
}

absl::StatusOr<v1::CreateJobResponse> OrchestratorHandlers::CreateJob(const v1::CreateJobRequest& request,
                                                                      const Caller& caller) {
  RETURN_IF_ERROR(Validate(request));
  RETURN_IF_ERROR(CheckSpec(request.spec(), caller));
  JobAdmission::Entry entry(admission_, caller);
  RETURN_IF_ERROR(UnlessRepeated(entry.Grant(1), RequestKind::kJob, request.request_id(), caller));
  v1::Job job = NewJob(request.spec());
  job.set_id(ids_.Next());
  job.set_owner(caller.name);
  ASSIGN_OR_RETURN(v1::Job made, queue_.CreateJob(job, caller.RequestKey(request.request_id())));
  if (runtime::CanonicalBytes(made.spec()) != runtime::CanonicalBytes(request.spec())) {
    return absl::AlreadyExistsError(
        fmt::format("request_id: \"{}\" made job {} with another spec; use a new id", request.request_id(), made.id()));
  }
  runner_.Request({made.id()});
  v1::CreateJobResponse response;
  *response.mutable_job() = std::move(made);
  return response;
}

absl::StatusOr<v1::GetJobResponse> OrchestratorHandlers::GetJob(const v1::GetJobRequest& request,
                                                                const Caller& caller) {
  v1::GetJobResponse response;
  ASSIGN_OR_RETURN(*response.mutable_job(), VisibleJob(request.job_id(), caller));
  return response;
}

absl::StatusOr<v1::ListJobsResponse> OrchestratorHandlers::ListJobs(const v1::ListJobsRequest& request,
                                                                    const Caller& caller) {
  ASSIGN_OR_RETURN(const int limit, PageLimit(request.page_size()));
  ListFilter filter;
  filter.limit = limit + 1;
  filter.before = request.page_token();
  filter.owner = caller.OwnerFilter();
  filter.batch_id = request.batch_id();
  filter.state = request.state();
  ASSIGN_OR_RETURN(std::vector<v1::Job> jobs, queue_.ListJobs(filter));
  return PageOf<v1::ListJobsResponse>(std::move(jobs), limit,
                                      [](v1::ListJobsResponse& page) { return page.mutable_jobs(); });
}

absl::StatusOr<v1::CancelJobResponse> OrchestratorHandlers::CancelJob(const v1::CancelJobRequest& request,
                                                                      const Caller& caller) {
  RETURN_IF_ERROR(VisibleJob(request.job_id(), caller).status());
  RETURN_IF_ERROR(queue_.Cancel(request.job_id(), clock_.Now()));
  v1::CancelJobResponse response;
  ASSIGN_OR_RETURN(*response.mutable_job(), queue_.GetJob(request.job_id()));
  return response;
}

absl::StatusOr<v1::GetArtifactResponse> OrchestratorHandlers::GetArtifact(const v1::GetArtifactRequest& request,
                                                                          const Caller& caller) {
  if (!caller.sees_all) {
    ASSIGN_OR_RETURN(const bool owns, queue_.OwnsArtifact(caller.name, request.artifact_id()));
    if (!owns) {
      return absl::NotFoundError(fmt::format("artifact {}: not in this store", request.artifact_id().substr(0, 80)));
    }
  }
  v1::GetArtifactResponse response;
  ASSIGN_OR_RETURN(*response.mutable_artifact(), artifacts_.Get(request.artifact_id()));
  return response;
}

absl::StatusOr<v1::GetClusterResponse> OrchestratorHandlers::GetCluster(const v1::GetClusterRequest&,
                                                                        const Caller& caller) {
  RETURN_IF_ERROR(caller.CheckOperator("GetCluster"));
  ASSIGN_OR_RETURN(const int64_t queued, queue_.CountQueued());
  ASSIGN_OR_RETURN(const std::vector<v1::OrchestratorStatus> others, queue_.Orchestrators());
  v1::GetClusterResponse response;
  response.set_queued_count(queued);
  v1::OrchestratorStatus& own = *response.add_orchestrators();
  own = status_();
  for (const v1::OrchestratorStatus& other : others) {
    if (other.id() != own.id()) *response.add_orchestrators() = other;
  }
  return response;
}

}  // namespace flair::orchestrator
