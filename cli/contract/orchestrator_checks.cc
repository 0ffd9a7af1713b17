// SPDX-License-Identifier: GPL-3.0-or-later
// Orchestrator: jobs, their events and artifacts. These checks give it real jobs, which stay in its store.
#include <grpcpp/client_context.h>

#include <algorithm>

#include "absl/time/clock.h"
#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/validate.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

v1::CreateJobRequest NewJob(Target& target) {
  v1::CreateJobRequest request;
  request.set_request_id(target.NewRequestId());
  *request.mutable_spec() = BedroomJob();
  return request;
}

// Events after `after`, until the job ends or the patience does; at most `most` of them.
absl::StatusOr<std::vector<v1::JobEvent>> Watch(const Target& target, const std::string& job_id, int64_t after = 0,
                                                size_t most = 1000) {
  const auto stub = v1::OrchestratorService::NewStub(target.channel());
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + target.options().patience));
  v1::WatchJobRequest request;
  request.set_job_id(job_id);
  request.set_after_sequence(after);
  const auto reader = stub->WatchJob(&context, request);
  std::vector<v1::JobEvent> events;
  v1::WatchJobResponse response;
  while (events.size() < most && reader->Read(&response)) events.push_back(response.event());
  const bool left = events.size() == most;
  if (left) context.TryCancel();
  const grpc::Status status = reader->Finish();
  if (!status.ok() && !left) return runtime::FromGrpcStatus(status);
  return events;
}

// A new job that has run to its end, with its events; an error in words otherwise.
struct Done {
  v1::Job job;
  std::vector<v1::JobEvent> events;
};

absl::StatusOr<Done> RunAJob(Target& target) {
  const auto created = target.Ask<v1::CreateJobResponse>(NewJob(target));
  if (!created.ok()) return created.status();
  auto events = Watch(target, created->job().id());
  if (!events.ok()) return events.status();
  v1::GetJobRequest request;
  request.set_job_id(created->job().id());
  const auto job = target.Ask<v1::GetJobResponse>(request);
  if (!job.ok()) return job.status();
  return Done{job->job(), *std::move(events)};
}

// Runs a job and judges it: Finding(const Done&).
template <typename Judge>
Finding OfAJob(Target& target, const Judge& judge) {
  const absl::StatusOr<Done> done = RunAJob(target);
  if (!done.ok()) return Broken("CreateJob of a small bedroom, then WatchJob", StatusText(done.status()), "its events");
  if (done->job.state() != v1::JOB_STATE_SUCCEEDED) {
    return Broken("CreateJob of a small bedroom, then WatchJob",
                  fmt::format("{}: {}", v1::JobState_Name(done->job.state()), done->job.error()),
                  "a job that succeeds; are its stages running?");
  }
  return judge(*done);
}

Finding EventsAreComplete(Target& target) {
  return OfAJob(target, [](const Done& done) {
    const std::string sent = "WatchJob of a job";
    for (size_t i = 0; i < done.events.size(); ++i) {
      if (done.events[i].sequence() == static_cast<int64_t>(i) + 1 && done.events[i].job_id() == done.job.id())
        continue;
      return Broken(sent, fmt::format("event {}: {{ {} }}", i, done.events[i].ShortDebugString()),
                    "events of this job, sequence counting up from 1");
    }
    if (!done.events.empty() && done.events.back().kind() == v1::JOB_EVENT_KIND_ENDED) return Kept();
    return Broken(sent, fmt::format("{} events, the last of which does not end the job", done.events.size()),
                  "a stream that ends after JOB_EVENT_KIND_ENDED");
  });
}

Finding WatchGoesOnWhereItStopped(Target& target) {
  return OfAJob(target, [&target](const Done& done) {
    const int64_t seen = done.events[done.events.size() / 2].sequence();
    const std::string sent = fmt::format("WatchJob of an ended job after event {}", seen);
    const auto rest = Watch(target, done.job.id(), seen);
    if (!rest.ok()) return Broken(sent, StatusText(rest.status()), "the events after it");
    const size_t expected = done.events.size() - static_cast<size_t>(seen);
    if (rest->size() == expected && (rest->empty() || rest->front().sequence() == seen + 1)) return Kept();
    return Broken(sent, fmt::format("{} events", rest->size()), fmt::format("the {} events after it", expected));
  });
}

Finding LeavingAWatchHarmsNobody(Target& target) {
  const auto created = target.Ask<v1::CreateJobResponse>(NewJob(target));
  if (!created.ok()) return Broken("CreateJob of a small bedroom", StatusText(created.status()), "a job");
  const std::string sent = "WatchJob, left after the first event, and WatchJob again";
  if (const auto first = Watch(target, created->job().id(), 0, 1); !first.ok()) {
    return Broken(sent, StatusText(first.status()), "its events");
  }
  const auto again = Watch(target, created->job().id());
  if (!again.ok()) return Broken(sent, StatusText(again.status()), "all events");
  const bool whole = !again->empty() && again->back().kind() == v1::JOB_EVENT_KIND_ENDED;
  return whole ? Kept() : Broken(sent, "a stream without end", "all events, the end too");
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
  return OfAJob(target, [&target](const Done& done) {
    if (done.job.artifacts().empty()) return Broken("GetJob of an ended job", "no artifacts", "those of its stages");
    for (const v1::ArtifactRef& ref : done.job.artifacts()) {
      v1::GetArtifactRequest request;
      request.set_artifact_id(ref.id());
      const std::string sent = fmt::format("GetArtifact of the job's {}", v1::ArtifactKind_Name(ref.kind()));
      const auto answer = target.Ask<v1::GetArtifactResponse>(request);
      if (!answer.ok()) return Broken(sent, StatusText(answer.status()), "the artifact");
      const std::string fault = ArtifactFault(ref, answer->artifact());
      if (!fault.empty()) {
        return Broken(sent, fault, "a valid artifact whose id is the SHA-256 of its canonical bytes without the id");
      }
    }
    return Kept();
  });
}

// Ids of the artifacts but the report, which holds times.
std::vector<std::string> ResultIds(const v1::Job& job) {
  std::vector<std::string> ids;
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    if (ref.kind() != v1::ARTIFACT_KIND_REPORT) ids.push_back(ref.id());
  }
  return ids;
}

Finding EqualJobsHaveEqualArtifacts(Target& target) {
  return OfAJob(target, [&target](const Done& first) {
    return OfAJob(target, [&first](const Done& second) {
      if (ResultIds(first.job) == ResultIds(second.job)) return Kept();
      return Broken("CreateJob of one spec twice", "artifacts that differ", "the same ids, but for the report");
    });
  });
}

Finding RepeatsGetTheFirstJob(Target& target) {
  const v1::CreateJobRequest request = NewJob(target);
  const std::string sent = "CreateJob twice with one request_id";
  return Given<v1::CreateJobResponse>(target, sent, request, [&](const v1::CreateJobResponse& first) {
    return Given<v1::CreateJobResponse>(target, sent, request, [&](const v1::CreateJobResponse& second) {
      if (first.job().id() == second.job().id()) return Kept();
      return Broken(sent, fmt::format("jobs {} and {}", first.job().id(), second.job().id()), "the first job again");
    });
  });
}

Finding OtherSpecsAreRefused(Target& target) {
  v1::CreateJobRequest request = NewJob(target);
  return Given<v1::CreateJobResponse>(target, "CreateJob", request, [&](const v1::CreateJobResponse&) {
    request.mutable_spec()->mutable_brief()->set_seed(4);
    const absl::Status status = target.Ask<v1::CreateJobResponse>(request).status();
    if (absl::IsAlreadyExists(status)) return Kept();
    return Broken("CreateJob with the request_id of another spec", status.ok() ? "OK, with a job" : StatusText(status),
                  "ALREADY_EXISTS");
  });
}

Finding CancelEndsAJob(Target& target) {
  const auto created = target.Ask<v1::CreateJobResponse>(NewJob(target));
  if (!created.ok()) return Broken("CreateJob of a small bedroom", StatusText(created.status()), "a job");
  v1::CancelJobRequest request;
  request.set_job_id(created->job().id());
  const std::string sent = "CreateJob, CancelJob, and CancelJob again";
  return Given<v1::CancelJobResponse>(target, sent, request, [&](const v1::CancelJobResponse&) {
    if (const auto events = Watch(target, request.job_id()); !events.ok()) {
      return Broken(sent + ", then WatchJob", StatusText(events.status()), "a stream that ends");
    }
    return Given<v1::CancelJobResponse>(target, sent, request, [&](const v1::CancelJobResponse& again) {
      // It may have been quicker than the cancel.
      const v1::JobState state = again.job().state();
      if (state == v1::JOB_STATE_CANCELLED || state == v1::JOB_STATE_SUCCEEDED) return Kept();
      return Broken(sent, v1::JobState_Name(state), "JOB_STATE_CANCELLED, unchanged by the second call");
    });
  });
}

Finding ListsNewestFirst(Target& target) {
  for (int i = 0; i < 2; ++i) {
    const auto created = target.Ask<v1::CreateJobResponse>(NewJob(target));
    if (!created.ok()) return Broken("CreateJob of a small bedroom", StatusText(created.status()), "a job");
  }
  v1::ListJobsRequest request;
  request.set_page_size(1);
  const std::string sent = "ListJobs, page after page of one job";
  return Given<v1::ListJobsResponse>(target, sent, request, [&](const v1::ListJobsResponse& first) {
    request.set_page_token(first.next_page_token());
    return Given<v1::ListJobsResponse>(target, sent, request, [&](const v1::ListJobsResponse& second) {
      if (first.jobs_size() == 1 && second.jobs_size() == 1 && first.jobs(0).id() > second.jobs(0).id()) return Kept();
      return Broken(sent, fmt::format("pages of {} and {} jobs, in no order", first.jobs_size(), second.jobs_size()),
                    "a page of one job and an older one on the next; ids sort by age");
    });
  });
}

Finding DeletedJobsAreGone(Target& target) {
  return OfAJob(target, [&target](const Done& done) {
    const std::string sent = "DeleteJob of an ended job, GetJob, GetArtifact of its report, DeleteJob again";
    v1::DeleteJobRequest request;
    request.set_job_id(done.job.id());
    const auto deleted = target.Ask<v1::DeleteJobResponse>(request);
    if (!deleted.ok()) return Broken(sent, StatusText(deleted.status()), "what was deleted");
    // The report names the job: no other one has it.
    if (deleted->deleted_artifact_count() < 1) return Broken(sent, "no artifact deleted", "its report at least");
    v1::GetJobRequest job;
    job.set_job_id(done.job.id());
    v1::GetArtifactRequest artifact;
    for (const v1::ArtifactRef& ref : done.job.artifacts()) {
      if (ref.kind() == v1::ARTIFACT_KIND_REPORT) artifact.set_artifact_id(ref.id());
    }
    for (const absl::Status& status :
         {target.Ask<v1::GetJobResponse>(job).status(), target.Ask<v1::GetArtifactResponse>(artifact).status(),
          target.Ask<v1::DeleteJobResponse>(request).status()}) {
      if (!absl::IsNotFound(status))
        return Broken(sent, status.ok() ? "OK" : StatusText(status), "NOT_FOUND each time");
    }
    return Kept();
  });
}

Finding RequestsOfDeletedJobsAreFree(Target& target) {
  const v1::CreateJobRequest create = NewJob(target);
  const std::string sent = "CreateJob, WatchJob, DeleteJob, and CreateJob with the same request_id";
  return Given<v1::CreateJobResponse>(target, sent, create, [&](const v1::CreateJobResponse& first) {
    if (const auto events = Watch(target, first.job().id()); !events.ok()) {
      return Broken(sent, StatusText(events.status()), "its events");
    }
    v1::DeleteJobRequest request;
    request.set_job_id(first.job().id());
    return Given<v1::DeleteJobResponse>(target, sent, request, [&](const v1::DeleteJobResponse&) {
      return Given<v1::CreateJobResponse>(target, sent, create, [&](const v1::CreateJobResponse& second) {
        return second.job().id() != first.job().id() ? Kept() : Broken(sent, "the deleted job", "another job");
      });
    });
  });
}

}  // namespace

Sample OrchestratorSample() {
  const auto request = std::make_shared<v1::ListJobsRequest>();
  return {.what = "ListJobs",
          .request = request,
          .fault =
              [](const std::string& bytes) {
                v1::ListJobsResponse answer;
                if (!answer.ParseFromString(bytes)) return std::string("bytes that are no ListJobsResponse");
                return answer.jobs_size() <= 50 ? "" : fmt::format("a page of {} jobs", answer.jobs_size());
              },
          .long_requests = {request}};
}

void AddOrchestratorChecks(Checks& checks) {
  checks.push_back({"A job's events count up from 1 and end with its end", Promise::kMessages, EventsAreComplete});
  checks.push_back({"Watching goes on after the last event seen", Promise::kMessages, WatchGoesOnWhereItStopped});
  checks.push_back({"Who leaves a watch harms nobody", Promise::kCallers, LeavingAWatchHarmsNobody});
  checks.push_back(
      {"Artifacts are valid and have the ids of their bytes", Promise::kMessages, ArtifactsAreWhatTheyAreCalled});
  checks.push_back({"Jobs of one spec come to the same artifacts", Promise::kRepetition, EqualJobsHaveEqualArtifacts,
                    v1::CAPABILITY_DETERMINISTIC});
  checks.push_back({"A repeated CreateJob gets the first job", Promise::kRepetition, RepeatsGetTheFirstJob});
  checks.push_back({"A request_id with another spec is refused", Promise::kRepetition, OtherSpecsAreRefused});
  checks.push_back({"CancelJob ends a job, and again changes nothing", Promise::kCallers, CancelEndsAJob});
  checks.push_back({"DeleteJob deletes a job and its artifacts", Promise::kCallers, DeletedJobsAreGone});
  checks.push_back(
      {"After DeleteJob, its request makes another job", Promise::kRepetition, RequestsOfDeletedJobsAreFree});
  checks.push_back({"ListJobs goes from the newest to older ones, page by page", Promise::kMessages, ListsNewestFirst});
  AddBatchChecks(checks);
  AddOrchestratorRefusals(checks);
}

}  // namespace flair::contract
