// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/orchestrator_handlers.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <optional>

#include "orchestrator/pipeline/stage.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"

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
  return NotFound("job_id: no job \"{}\" in this store", id.substr(0, 80));
}

absl::StatusOr<GivenArtifact> OrchestratorHandlers::Given(v1::Artifact layout) {
  constexpr int64_t kMostBytes = int64_t{4} << 20;
  if (!layout.has_solved_layout()) return absl::InvalidArgumentError("layout: holds no solved_layout");
  const std::string stated = layout.id();
  GivenArtifact given{.artifact = SealArtifact(layout), .record = {}, .store = &artifacts_};
  const v1::ArtifactRef& ref = given.artifact.ref;
  if (!stated.empty() && stated != ref.id()) {
    return InvalidArgument("layout.id: \"{}\" is not that of its bytes, {}", stated.substr(0, 80), ref.id());
  }
  if (ref.size_bytes() > kMostBytes) {
    return InvalidArgument("layout: {} bytes; at most {}", ref.size_bytes(), kMostBytes);
  }
  v1::JobEvent& event = given.record.event;
  event.set_kind(v1::JOB_EVENT_KIND_STAGE_REUSED);
  event.set_stage(std::string(kSolve));
  event.set_message(Summarize(layout));
  *event.mutable_artifact() = ref;
  event.set_state(v1::JOB_STATE_QUEUED);
  given.record.stage_index = StageIndex(kSolve);
  return given;
}

absl::StatusOr<v1::CreateJobResponse> OrchestratorHandlers::CreateJob(const v1::CreateJobRequest& request,
                                                                      const Caller& caller) {
  RETURN_IF_ERROR(Validate(request));
  RETURN_IF_ERROR(CheckSpec(request.spec(), caller));
  std::optional<GivenArtifact> given;
  if (request.has_layout()) {
    if (request.spec().has_replay()) return absl::InvalidArgumentError("layout: a replay makes or takes its own");
    ASSIGN_OR_RETURN(given, Given(request.layout()));
  }
  JobAdmission::Entry entry(admission_, caller);
  RETURN_IF_ERROR(UnlessRepeated(entry.Grant(1), RequestKind::kJob, request.request_id(), caller));
  v1::Job job = NewJob(request.spec());
  job.set_id(ids_.Next());
  job.set_owner(caller.name);
  ASSIGN_OR_RETURN(v1::Job made, queue_.CreateJob(job, caller.RequestKey(request.request_id()),
                                                  given.has_value() ? &*given : nullptr));
  const v1::ArtifactRef* const layout = GivenLayout(made);
  const bool same_layout =
      (layout == nullptr ? "" : layout->id()) == (given.has_value() ? given->artifact.ref.id() : "");
  if (!same_layout || runtime::CanonicalBytes(made.spec()) != runtime::CanonicalBytes(request.spec())) {
    return absl::AlreadyExistsError(fmt::format(
        "request_id: \"{}\" made job {} with another spec or layout; use a new id", request.request_id(), made.id()));
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
      return NotFound("artifact {}: not in this store", request.artifact_id().substr(0, 80));
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

std::shared_ptr<std::mutex> JobAdmission::TurnOf(const std::string& owner) {
  std::lock_guard lock(mutex_);
  std::erase_if(turns_, [](const auto& turn) { return turn.second.expired(); });
  std::weak_ptr<std::mutex>& known = turns_[owner];
  std::shared_ptr<std::mutex> turn = known.lock();
  if (turn == nullptr) known = turn = std::make_shared<std::mutex>();
  return turn;
}

JobAdmission::Entry::Entry(JobAdmission& admission, const Caller& caller) : admission_(admission), caller_(caller) {
  if (caller.open_job_limit == 0) return;
  turn_ = admission.TurnOf(caller.name);
  turn_->lock();
}

JobAdmission::Entry::~Entry() {
  {
    std::lock_guard lock(admission_.mutex_);
    admission_.kept_ -= kept_;
  }
  if (turn_ != nullptr) turn_->unlock();
}

absl::StatusOr<JobAdmission::Entry::Counts> JobAdmission::Entry::Keep(int64_t job_count) {
  int64_t others = 0;
  {
    // Before the queue is counted: what others add meanwhile is counted twice rather than not at all.
    std::lock_guard lock(admission_.mutex_);
    others = admission_.kept_ - kept_;
    admission_.kept_ = others + job_count;
    kept_ = job_count;
  }
  ASSIGN_OR_RETURN(const int64_t queued, admission_.queue_.CountQueued());
  Counts counts = {.queued = queued + others};
  if (turn_ == nullptr) return counts;
  ASSIGN_OR_RETURN(counts.open, admission_.queue_.CountOpen(caller_.name));
  return counts;
}

absl::Status JobAdmission::Entry::Check(const Counts& counts, int64_t job_count) const {
  if (counts.queued + job_count <= admission_.queued_job_limit_) return caller_.CheckOpenJobs(counts.open, job_count);
  return ResourceExhausted("{} jobs are waiting; {} more would exceed the limit of {}; try again later", counts.queued,
                           job_count, admission_.queued_job_limit_);
}

absl::Status JobAdmission::Entry::Grant(int64_t job_count) {
  if (job_count <= kept_) return absl::OkStatus();
  const absl::StatusOr<Counts> counts = Keep(job_count);
  const absl::Status status = counts.ok() ? Check(*counts, job_count) : counts.status();
  if (status.ok()) return status;
  std::lock_guard lock(admission_.mutex_);
  admission_.kept_ -= kept_;
  kept_ = 0;
  return status;
}

absl::StatusOr<int64_t> JobAdmission::Entry::GrantSome(int64_t job_count) {
  ASSIGN_OR_RETURN(const Counts counts, Keep(job_count));
  int64_t room = admission_.queued_job_limit_ - counts.queued;
  if (caller_.open_job_limit > 0) room = std::min(room, caller_.open_job_limit - counts.open);
  return std::clamp<int64_t>(room, 0, job_count);
}

}  // namespace flair::orchestrator
