// SPDX-License-Identifier: GPL-3.0-or-later
// Orchestrator: jobs, their events and artifacts. These checks give it real jobs, which stay in its store.
#include <algorithm>
#include <limits>

#include "cli/contract/bedroom.h"
#include "cli/contract/stage_checks.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

constexpr size_t kAll = std::numeric_limits<size_t>::max();

template <typename Request>
Request OfJob(const std::string& id) {
  Request request;
  request.set_job_id(id);
  return request;
}

v1::CreateJobRequest NewJob(Target& target) {
  v1::CreateJobRequest request;
  request.set_request_id(target.NewRequestId());
  *request.mutable_spec() = BedroomJob();
  return request;
}

absl::StatusOr<std::string> CreateJob(Target& target, const v1::CreateJobRequest& request) {
  ASSIGN_OR_RETURN(const v1::CreateJobResponse created, target.Ask<v1::CreateJobResponse>(request));
  return created.job().id();
}

// Events after `after`, until the job ends or the patience does; at most `most` of them.
absl::StatusOr<std::vector<v1::JobEvent>> WatchJob(const Target& target, const std::string& id, int64_t after = 0,
                                                   size_t most = kAll) {
  auto request = OfJob<v1::WatchJobRequest>(id);
  request.set_after_sequence(after);
  ASSIGN_OR_RETURN(const auto answers, target.Stream<v1::WatchJobResponse>(std::vector{request}, most));
  std::vector<v1::JobEvent> events;
  for (const v1::WatchJobResponse& answer : answers) events.push_back(answer.event());
  return events;
}

// A new job that has succeeded, with its events.
struct Done {
  v1::Job job;
  std::vector<v1::JobEvent> events;
};

absl::StatusOr<Done> RunAJob(Target& target) {
  Done done;
  ASSIGN_OR_RETURN(const std::string id, CreateJob(target, NewJob(target)));
  ASSIGN_OR_RETURN(done.events, WatchJob(target, id));
  ASSIGN_OR_RETURN(const v1::GetJobResponse answer, target.Ask<v1::GetJobResponse>(OfJob<v1::GetJobRequest>(id)));
  done.job = answer.job();
  if (done.job.state() == v1::JOB_STATE_SUCCEEDED) return done;
  return absl::UnknownError(
      fmt::format("the job is {}: {}; are its stages running?", v1::JobState_Name(done.job.state()), done.job.error()));
}

Finding EventsAreComplete(Target& target) {
  ASSIGN_OR_RETURN(const Done done, RunAJob(target));
  for (size_t i = 0; i < done.events.size(); ++i) {
    const v1::JobEvent& event = done.events[i];
    if (event.sequence() == static_cast<int64_t>(i) + 1 && event.job_id() == done.job.id()) continue;
    return Wrong(fmt::format("event {}: {{ {} }}", i, event.ShortDebugString()));
  }
  if (!done.events.empty() && done.events.back().kind() == v1::JOB_EVENT_KIND_ENDED) return Kept();
  return Wrong(fmt::format("{} events, the last of which does not end the job", done.events.size()));
}

Finding WatchGoesOnWhereItStopped(Target& target) {
  ASSIGN_OR_RETURN(const Done done, RunAJob(target));
  if (done.events.empty()) return Wrong("no events");
  const int64_t seen = done.events[done.events.size() / 2].sequence();
  ASSIGN_OR_RETURN(const auto rest, WatchJob(target, done.job.id(), seen));
  const size_t expected = done.events.size() - static_cast<size_t>(seen);
  if (rest.size() == expected && (rest.empty() || rest.front().sequence() == seen + 1)) return Kept();
  return Wrong(fmt::format("{} events", rest.size()), fmt::format("the {} events after it", expected));
}

Finding LeavingAWatchHarmsNobody(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, CreateJob(target, NewJob(target)));
  RETURN_IF_ERROR(WatchJob(target, id, 0, 1).status());
  ASSIGN_OR_RETURN(const auto again, WatchJob(target, id));
  const bool whole = !again.empty() && again.back().kind() == v1::JOB_EVENT_KIND_ENDED;
  return whole ? Kept() : Wrong("a stream without end");
}

// What is wrong with a stored artifact; empty when nothing is.
std::string ArtifactFault(const v1::ArtifactRef& ref, const v1::Artifact& artifact) {
  if (const absl::Status status = Validate(artifact); !status.ok()) return std::string(status.message());
  if (artifact.id() != ref.id()) return fmt::format("an artifact of id {}", artifact.id());
  const std::string digest = orchestrator::ComputeArtifactId(artifact);
  if (digest != ref.id()) return fmt::format("bytes whose digest is {}", digest);
  return artifact.producer().program().empty() && artifact.has_room() ? "a room without a producer" : "";
}

Finding ArtifactsAreWhatTheyAreCalled(Target& target) {
  ASSIGN_OR_RETURN(const Done done, RunAJob(target));
  if (done.job.artifacts().empty()) return Wrong("no artifacts", "those of its stages", "GetJob of an ended job");
  for (const v1::ArtifactRef& ref : done.job.artifacts()) {
    v1::GetArtifactRequest request;
    request.set_artifact_id(ref.id());
    const auto answer = target.Ask<v1::GetArtifactResponse>(request);
    const std::string fault = answer.ok() ? ArtifactFault(ref, answer->artifact()) : StatusText(answer.status());
    if (fault.empty()) continue;
    return Wrong(fault, "", fmt::format("GetArtifact of the job's {}", v1::ArtifactKind_Name(ref.kind())));
  }
  return Kept();
}

// Ids of the artifacts of this kind, or of all others.
std::vector<std::string> ArtifactIds(const v1::Job& job, v1::ArtifactKind kind, bool others) {
  std::vector<std::string> ids;
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    if ((ref.kind() == kind) != others) ids.push_back(ref.id());
  }
  return ids;
}

// But for the report, which holds times.
Finding EqualJobsHaveEqualArtifacts(Target& target) {
  ASSIGN_OR_RETURN(const Done first, RunAJob(target));
  ASSIGN_OR_RETURN(const Done second, RunAJob(target));
  const bool equal =
      ArtifactIds(first.job, v1::ARTIFACT_KIND_REPORT, true) == ArtifactIds(second.job, v1::ARTIFACT_KIND_REPORT, true);
  return equal ? Kept() : Wrong("artifacts that differ");
}

Finding RepeatsGetTheFirstJob(Target& target) {
  const v1::CreateJobRequest request = NewJob(target);
  ASSIGN_OR_RETURN(const std::string first, CreateJob(target, request));
  ASSIGN_OR_RETURN(const std::string second, CreateJob(target, request));
  return first == second ? Kept() : Wrong(fmt::format("jobs {} and {}", first, second));
}

Finding OtherSpecsAreRefused(Target& target) {
  v1::CreateJobRequest request = NewJob(target);
  RETURN_IF_ERROR(CreateJob(target, request).status());
  request.mutable_spec()->mutable_brief()->set_seed(4);
  return RefusedAs(absl::StatusCode::kAlreadyExists, CreateJob(target, request).status());
}

Finding CancelEndsAJob(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, CreateJob(target, NewJob(target)));
  const auto request = OfJob<v1::CancelJobRequest>(id);
  RETURN_IF_ERROR(target.AskForBytes(request).status());
  RETURN_IF_ERROR(WatchJob(target, id).status());
  ASSIGN_OR_RETURN(const v1::CancelJobResponse again, target.Ask<v1::CancelJobResponse>(request));
  // It may have been quicker than the cancel.
  const v1::JobState state = again.job().state();
  if (state == v1::JOB_STATE_CANCELLED || state == v1::JOB_STATE_SUCCEEDED) return Kept();
  return Wrong(v1::JobState_Name(state));
}

Finding ListsNewestFirst(Target& target) {
  for (int i = 0; i < 2; ++i) RETURN_IF_ERROR(CreateJob(target, NewJob(target)).status());
  v1::ListJobsRequest request;
  request.set_page_size(1);
  ASSIGN_OR_RETURN(const v1::ListJobsResponse first, target.Ask<v1::ListJobsResponse>(request));
  request.set_page_token(first.next_page_token());
  ASSIGN_OR_RETURN(const v1::ListJobsResponse second, target.Ask<v1::ListJobsResponse>(request));
  if (first.jobs_size() == 1 && second.jobs_size() == 1 && first.jobs(0).id() > second.jobs(0).id()) return Kept();
  return Wrong(fmt::format("pages of {} and {} jobs, in no order", first.jobs_size(), second.jobs_size()));
}

Finding DeletedJobsAreGone(Target& target) {
  ASSIGN_OR_RETURN(const Done done, RunAJob(target));
  const auto request = OfJob<v1::DeleteJobRequest>(done.job.id());
  ASSIGN_OR_RETURN(const v1::DeleteJobResponse deleted, target.Ask<v1::DeleteJobResponse>(request));
  // The report names the job: no other one has it.
  const std::vector<std::string> reports = ArtifactIds(done.job, v1::ARTIFACT_KIND_REPORT, false);
  if (deleted.deleted_artifact_count() < 1 || reports.empty()) return Wrong("no artifact deleted");
  v1::GetArtifactRequest artifact;
  artifact.set_artifact_id(reports.front());
  const auto job = OfJob<v1::GetJobRequest>(done.job.id());
  for (const google::protobuf::Message* gone :
       std::initializer_list<const google::protobuf::Message*>{&job, &artifact, &request}) {
    const absl::Status status = target.AskForBytes(*gone).status();
    if (!absl::IsNotFound(status)) return Wrong(fmt::format("{} says {}", RpcName(*gone), StatusText(status)));
  }
  return Kept();
}

Finding RequestsOfDeletedJobsAreFree(Target& target) {
  const v1::CreateJobRequest create = NewJob(target);
  ASSIGN_OR_RETURN(const std::string first, CreateJob(target, create));
  RETURN_IF_ERROR(WatchJob(target, first).status());
  RETURN_IF_ERROR(target.AskForBytes(OfJob<v1::DeleteJobRequest>(first)).status());
  ASSIGN_OR_RETURN(const std::string second, CreateJob(target, create));
  return second != first ? Kept() : Wrong("the deleted job");
}

std::string PageFault(const v1::ListJobsResponse& answer) {
  return answer.jobs_size() <= 50 ? "" : fmt::format("a page of {} jobs", answer.jobs_size());
}

}  // namespace

Sample OrchestratorSample() {
  const auto request = std::make_shared<v1::ListJobsRequest>();
  return {.what = "ListJobs",
          .request = request,
          .fault = FaultOf<v1::ListJobsResponse>(PageFault),
          .core = {},
          .long_requests = {request}};
}

Checks JobChecks() {
  return {
      {"A job's events count up from 1 and end with its end", Promise::kMessages, "CreateJob, WatchJob",
       "events of this job, sequence counting up from 1, JOB_EVENT_KIND_ENDED last", EventsAreComplete},
      {"Watching goes on after the last event seen", Promise::kMessages, "WatchJob of an ended job after an event",
       "the events after it", WatchGoesOnWhereItStopped},
      {"Who leaves a watch harms nobody", Promise::kCallers, "WatchJob, left after the first event, and WatchJob again",
       "all events, the end too", LeavingAWatchHarmsNobody},
      {"Artifacts are valid and have the ids of their bytes", Promise::kMessages, "CreateJob, WatchJob, GetArtifact",
       "a valid artifact whose id is the SHA-256 of its canonical bytes without the id", ArtifactsAreWhatTheyAreCalled},
      {"Jobs of one spec come to the same artifacts", Promise::kRepetition, "CreateJob of one spec twice",
       "the same ids, but for the report", EqualJobsHaveEqualArtifacts, v1::CAPABILITY_DETERMINISTIC},
      {"A repeated CreateJob gets the first job", Promise::kRepetition, "CreateJob twice with one request_id",
       "the first job again", RepeatsGetTheFirstJob},
      {"A request_id with another spec is refused", Promise::kRepetition,
       "CreateJob with the request_id of another spec", "ALREADY_EXISTS", OtherSpecsAreRefused},
      {"CancelJob ends a job, and again changes nothing", Promise::kCallers,
       "CreateJob, CancelJob, WatchJob, and CancelJob again", "JOB_STATE_CANCELLED, unchanged by the second call",
       CancelEndsAJob},
      {"DeleteJob deletes a job and its artifacts", Promise::kCallers,
       "DeleteJob of an ended job, GetJob, GetArtifact of its report, DeleteJob again",
       "its report deleted at least, then NOT_FOUND each time", DeletedJobsAreGone},
      {"After DeleteJob, its request makes another job", Promise::kRepetition,
       "CreateJob, WatchJob, DeleteJob, and CreateJob with the same request_id", "another job",
       RequestsOfDeletedJobsAreFree},
      {"ListJobs goes from the newest to older ones, page by page", Promise::kMessages,
       "ListJobs, page after page of one job", "a page of one job and an older one on the next; ids sort by age",
       ListsNewestFirst},
  };
}

}  // namespace flair::contract
