// SPDX-License-Identifier: GPL-3.0-or-later
// Orchestrator: jobs, their events and artifacts, and batches. These checks give it real jobs, which stay in its store.
#include <algorithm>
#include <limits>
#include <set>

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

// Kept when a call was refused in this way.
Finding RefusedAs(absl::StatusCode code, const absl::Status& status) {
  if (status.code() == code) return Kept();
  return Wrong(StatusText(status), absl::StatusCodeToString(code));
}

template <typename Request>
Request OfJob(const std::string& id) {
  Request request;
  request.set_job_id(id);
  return request;
}

template <typename Request>
Request OfBatch(const std::string& id) {
  Request request;
  request.set_batch_id(id);
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

// The id of an open batch without jobs.
absl::StatusOr<std::string> OpenBatch(Target& target) {
  v1::CreateBatchRequest request;
  request.set_request_id(target.NewRequestId());
  request.set_open(true);
  ASSIGN_OR_RETURN(const v1::CreateBatchResponse created, target.Ask<v1::CreateBatchResponse>(request));
  return created.batch().id();
}

v1::AddToBatchRequest Page(const std::string& batch_id, int64_t first, int count, bool last) {
  auto request = OfBatch<v1::AddToBatchRequest>(batch_id);
  request.set_first_index(first);
  for (int i = 0; i < count; ++i) *request.add_specs() = BedroomJob();
  request.set_last(last);
  return request;
}

// The id of a closed batch of `count` jobs.
absl::StatusOr<std::string> ClosedBatch(Target& target, int count) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  RETURN_IF_ERROR(target.AskForBytes(Page(id, 0, count, true)).status());
  return id;
}

// The ends of a batch's jobs, until the stream or the patience ends; other than `count` of them are an error.
absl::StatusOr<std::vector<v1::WatchBatchResponse>> WatchBatch(const Target& target, const std::string& id,
                                                               size_t count, int64_t after = 0) {
  auto request = OfBatch<v1::WatchBatchRequest>(id);
  request.set_after_sequence(after);
  ASSIGN_OR_RETURN(auto ends, target.Stream<v1::WatchBatchResponse>(std::vector{request}));
  if (ends.size() == count) return ends;
  return absl::UnknownError(fmt::format("{} ends where {} were due", ends.size(), count));
}

Finding RepeatedBatchesAreOne(Target& target) {
  v1::CreateBatchRequest request;
  request.set_request_id(target.NewRequestId());
  *request.add_specs() = BedroomJob();
  *request.add_specs() = BedroomJob();
  ASSIGN_OR_RETURN(const v1::CreateBatchResponse first, target.Ask<v1::CreateBatchResponse>(request));
  ASSIGN_OR_RETURN(const v1::CreateBatchResponse second, target.Ask<v1::CreateBatchResponse>(request));
  const v1::Batch& batch = second.batch();
  const int counted = batch.open_count() + batch.succeeded_count() + batch.failed_count() + batch.cancelled_count();
  const bool same = batch.id() == first.batch().id() && batch.job_count() == 2 && counted == 2;
  return same ? Kept() : Wrong(batch.ShortDebugString());
}

Finding EveryEndComesOnce(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 3));
  ASSIGN_OR_RETURN(const auto ends, WatchBatch(target, id, 3));
  std::set<int64_t> places;
  int64_t sequence = 0;
  for (const v1::WatchBatchResponse& end : ends) {
    const bool ended = end.job().has_end_time() && end.job().batch_id() == id;
    if (!ended || end.sequence() <= sequence) return Wrong(end.ShortDebugString());
    sequence = end.sequence();
    places.insert(end.job().batch_index());
  }
  if (places != std::set<int64_t>{0, 1, 2}) return Wrong(fmt::format("ends of {} jobs", places.size()));
  return WatchBatch(target, id, 1, ends[1].sequence()).status();
}

Finding PagesMayBeRepeated(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  const v1::AddToBatchRequest page = Page(id, 0, 2, false);
  RETURN_IF_ERROR(target.AskForBytes(page).status());
  ASSIGN_OR_RETURN(const v1::AddToBatchResponse again, target.Ask<v1::AddToBatchResponse>(page));
  return again.batch().job_count() == 2 ? Kept() : Wrong(fmt::format("a batch of {} jobs", again.batch().job_count()));
}

Finding GapsAreRefused(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  return RefusedAs(absl::StatusCode::kFailedPrecondition, target.AskForBytes(Page(id, 5, 1, false)).status());
}

Finding ClosedBatchesDoNotGrow(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 1));
  return RefusedAs(absl::StatusCode::kFailedPrecondition, target.AskForBytes(Page(id, 1, 1, false)).status());
}

Finding OtherSpecsKeepTheirPlace(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 1));
  v1::AddToBatchRequest page = Page(id, 0, 1, true);
  page.mutable_specs(0)->mutable_brief()->set_seed(4);
  return RefusedAs(absl::StatusCode::kAlreadyExists, target.AskForBytes(page).status());
}

Finding PausedJobsWait(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  RETURN_IF_ERROR(target.AskForBytes(OfBatch<v1::PauseBatchRequest>(id)).status());
  RETURN_IF_ERROR(target.AskForBytes(Page(id, 0, 1, true)).status());
  ASSIGN_OR_RETURN(const std::string other, ClosedBatch(target, 1));
  RETURN_IF_ERROR(WatchBatch(target, other, 1).status());
  ASSIGN_OR_RETURN(const auto paused, target.Ask<v1::GetBatchResponse>(OfBatch<v1::GetBatchRequest>(id)));
  if (paused.batch().open_count() != 1 || paused.batch().state() != v1::BATCH_STATE_PAUSED) {
    return Wrong(paused.batch().ShortDebugString());
  }
  RETURN_IF_ERROR(target.AskForBytes(OfBatch<v1::ResumeBatchRequest>(id)).status());
  return WatchBatch(target, id, 1).status();
}

Finding CancelEndsAllJobs(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 3));
  RETURN_IF_ERROR(target.AskForBytes(OfBatch<v1::CancelBatchRequest>(id)).status());
  RETURN_IF_ERROR(WatchBatch(target, id, 3).status());
  return RefusedAs(absl::StatusCode::kFailedPrecondition,
                   target.AskForBytes(OfBatch<v1::ResumeBatchRequest>(id)).status());
}

Finding RetryTakesOnlyFailures(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 1));
  RETURN_IF_ERROR(WatchBatch(target, id, 1).status());
  ASSIGN_OR_RETURN(const auto retried, target.Ask<v1::RetryBatchResponse>(OfBatch<v1::RetryBatchRequest>(id)));
  return retried.retried_count() == 0 ? Kept() : Wrong(fmt::format("{} jobs", retried.retried_count()));
}

Finding DeletedBatchesAreGone(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 3));
  RETURN_IF_ERROR(WatchBatch(target, id, 3).status());
  int64_t jobs = 0;
  for (bool done = false; !done;) {
    ASSIGN_OR_RETURN(const auto deleted, target.Ask<v1::DeleteBatchResponse>(OfBatch<v1::DeleteBatchRequest>(id)));
    if (!deleted.done() && deleted.deleted_job_count() == 0 && deleted.deleted_artifact_count() == 0) {
      return Wrong("nothing deleted, and not done", "every call to go on");
    }
    jobs += deleted.deleted_job_count();
    done = deleted.done();
  }
  if (jobs != 3) return Wrong(fmt::format("{} jobs deleted", jobs), "three");
  return RefusedAs(absl::StatusCode::kNotFound, target.AskForBytes(OfBatch<v1::GetBatchRequest>(id)).status());
}

Finding OpenBatchesAreNotDeleted(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  return RefusedAs(absl::StatusCode::kFailedPrecondition,
                   target.AskForBytes(OfBatch<v1::DeleteBatchRequest>(id)).status());
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

Checks BatchChecks() {
  return {
      {"A repeated CreateBatch gets the first batch", Promise::kRepetition,
       "CreateBatch of two jobs twice with one request_id",
       "the first batch again, of two jobs, with counts that add up", RepeatedBatchesAreOne},
      {"WatchBatch tells the end of every job once", Promise::kMessages,
       "WatchBatch of three jobs, and again after the second end",
       "one end of each place, 0 to 2, with sequences that grow; then the third alone", EveryEndComesOnce},
      {"A page of jobs may be added again", Promise::kRepetition, "AddToBatch of two jobs twice", "the same two jobs",
       PagesMayBeRepeated},
      {"A page that leaves a gap is refused", Promise::kErrors, "AddToBatch that leaves a gap", "FAILED_PRECONDITION",
       GapsAreRefused},
      {"A closed batch does not grow", Promise::kErrors, "AddToBatch to a closed batch", "FAILED_PRECONDITION",
       ClosedBatchesDoNotGrow},
      {"A place in a batch keeps its spec", Promise::kRepetition, "AddToBatch of another spec to a place that is taken",
       "ALREADY_EXISTS", OtherSpecsKeepTheirPlace},
      {"A paused batch waits and goes on", Promise::kMessages,
       "PauseBatch, AddToBatch, another batch to its end, GetBatch, ResumeBatch, WatchBatch",
       "a paused batch whose job waits, and the job's end after ResumeBatch", PausedJobsWait},
      {"CancelBatch ends all jobs for ever", Promise::kCallers, "CancelBatch, WatchBatch, ResumeBatch",
       "three ends, then FAILED_PRECONDITION", CancelEndsAllJobs},
      {"RetryBatch takes failures only", Promise::kRepetition, "RetryBatch of a batch without failures", "no jobs",
       RetryTakesOnlyFailures},
      {"DeleteBatch deletes jobs and batch", Promise::kCallers,
       "WatchBatch of three jobs, DeleteBatch until it is done, GetBatch", "three jobs deleted, then NOT_FOUND",
       DeletedBatchesAreGone},
      {"DeleteBatch leaves an open batch alone", Promise::kErrors, "DeleteBatch of an open batch",
       "FAILED_PRECONDITION", OpenBatchesAreNotDeleted},
  };
}

}  // namespace flair::contract
