// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/session.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <set>
#include <string_view>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "cli/exit_code.h"
#include "cli/input/artifact_file.h"
#include "cli/input/service_flags.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {

namespace {

constexpr absl::Duration kJobAnswerWithin = absl::Seconds(30);
constexpr int kReconnects = 8;

// Unique enough to be the key of one wish of one process.
std::string NewRequestId() {
  std::random_device device;
  return fmt::format("cli-{:x}-{:x}{:08x}{:08x}", absl::ToUnixMicros(absl::Now()), getpid(), device(), device());
}

}  // namespace

Session::Session(std::unique_ptr<EmbeddedServices> services, std::shared_ptr<grpc::Channel> channel,
                 std::string address)
    : services_(std::move(services)),
      channel_(std::move(channel)),
      stub_(v1::OrchestratorService::NewStub(channel_)),
      address_(std::move(address)) {}

absl::StatusOr<std::unique_ptr<Session>> Session::Open(const std::string& address, const OptionalLlm& llm,
                                                       const StageChoice& stages,
                                                       const config::v1::OrchestratorConfig& orchestrator) {
  if (address.empty()) {
    ASSIGN_OR_RETURN(std::unique_ptr<EmbeddedServices> services,
                     EmbeddedServices::Start(DefaultStorePath(), llm, stages, orchestrator));
    std::shared_ptr<grpc::Channel> channel = services->orchestrator();
    return std::unique_ptr<Session>(new Session(std::move(services), std::move(channel), "this process"));
  }
  ASSIGN_OR_RETURN(const runtime::ChannelOptions options, OrchestratorConnection());
  ASSIGN_OR_RETURN(auto channel, runtime::MakeChannel(address, v1::OrchestratorService::service_full_name(), options));
  return std::unique_ptr<Session>(new Session(nullptr, std::move(channel), address));
}

absl::Status Session::Explain(const absl::Status& status) const {
  return embedded() ? status : NoOrchestrator(status, address_);
}

absl::Status Session::ExplainOfJob(const std::string& id, const absl::Status& status) const {
  if (!absl::IsNotFound(status)) return status;
  return absl::NotFoundError(fmt::format("{}: no such job {}; flair jobs lists them", id,
                                         embedded() ? "in the store " + DefaultStorePath() : "at " + address_));
}

template <typename Request, typename Response>
absl::StatusOr<Response> Session::Ask(
    grpc::Status (v1::OrchestratorService::StubInterface::*method)(grpc::ClientContext*, const Request&, Response*),
    const Request& request) {
  runtime::CallContext call;
  const absl::Time end = absl::Now() + kJobAnswerWithin;
  auto response = runtime::UnaryRequest(*stub_, method, request, call, end);
  if (runtime::SaidNoHello(response.status())) {
    fmt::print(stderr, "flair: {} is slow to answer; waiting for up to {} s\n", address_,
               absl::ToInt64Seconds(kJobAnswerWithin));
    if (channel_->WaitForConnected(absl::ToChronoTime(end))) {
      response = runtime::UnaryRequest(*stub_, method, request, call, end);
    }
  }
  if (!response.ok()) return Explain(response.status());
  return response;
}

absl::StatusOr<v1::Job> Session::CreateJob(const v1::JobSpec& spec) {
  v1::CreateJobRequest request;
  request.set_request_id(NewRequestId());
  *request.mutable_spec() = spec;
  ASSIGN_OR_RETURN(auto response, Ask(&v1::OrchestratorService::StubInterface::CreateJob, request));
  return response.job();
}

absl::StatusOr<v1::Job> Session::GetJob(const std::string& id) {
  v1::GetJobRequest request;
  request.set_job_id(id);
  auto response = Ask(&v1::OrchestratorService::StubInterface::GetJob, request);
  if (!response.ok()) return ExplainOfJob(id, response.status());
  return response->job();
}

absl::StatusOr<v1::Job> Session::CancelJob(const std::string& id) {
  v1::CancelJobRequest request;
  request.set_job_id(id);
  auto response = Ask(&v1::OrchestratorService::StubInterface::CancelJob, request);
  if (!response.ok()) return ExplainOfJob(id, response.status());
  return response->job();
}

absl::StatusOr<v1::DeleteJobResponse> Session::DeleteJob(const std::string& id) {
  v1::DeleteJobRequest request;
  request.set_job_id(id);
  auto response = Ask(&v1::OrchestratorService::StubInterface::DeleteJob, request);
  if (!response.ok()) return ExplainOfJob(id, response.status());
  return *std::move(response);
}

absl::StatusOr<std::vector<v1::Job>> Session::ListJobs(int count) {
  std::vector<v1::Job> jobs;
  v1::ListJobsRequest request;
  do {
    request.set_page_size(std::min(1000, count - static_cast<int>(jobs.size())));
    ASSIGN_OR_RETURN(auto response, Ask(&v1::OrchestratorService::StubInterface::ListJobs, request));
    jobs.insert(jobs.end(), response.jobs().begin(), response.jobs().end());
    request.set_page_token(response.next_page_token());
  } while (!request.page_token().empty() && static_cast<int>(jobs.size()) < count);
  return jobs;
}

absl::StatusOr<v1::Artifact> Session::GetArtifact(const std::string& id) {
  v1::GetArtifactRequest request;
  request.set_artifact_id(id);
  ASSIGN_OR_RETURN(auto response, Ask(&v1::OrchestratorService::StubInterface::GetArtifact, request));
  return std::move(*response.mutable_artifact());
}

absl::StatusOr<std::vector<std::string>> Session::FindIds(const std::string& prefix) {
  constexpr int kSearchedJobs = 1000;
  ASSIGN_OR_RETURN(const std::vector<v1::Job> jobs, ListJobs(kSearchedJobs));
  std::set<std::string> ids;
  for (const v1::Job& job : jobs) {
    for (const v1::ArtifactRef& ref : job.artifacts()) {
      if (ref.id().starts_with(prefix)) ids.insert(ref.id());
    }
  }
  return std::vector<std::string>(ids.begin(), ids.end());
}

absl::Status Session::Watch(const std::string& id, const std::function<void(const v1::JobEvent&)>& see) {
  v1::WatchJobRequest request;
  request.set_job_id(id);
  absl::Status status;
  for (int attempt = 0; attempt <= kReconnects; ++attempt) {
    if (attempt > 0) absl::SleepFor(absl::Milliseconds(200) * attempt);
    grpc::ClientContext context;
    auto reader = stub_->WatchJob(&context, request);
    v1::WatchJobResponse response;
    while (reader->Read(&response)) {
      request.set_after_sequence(response.event().sequence());
      see(response.event());
      if (response.event().kind() == v1::JOB_EVENT_KIND_ENDED) {
        context.TryCancel();
        reader->Finish();
        return absl::OkStatus();
      }
      attempt = 0;
    }
    status = runtime::FromGrpcStatus(reader->Finish());
    if (status.ok()) return status;
    if (status.code() != absl::StatusCode::kUnavailable) break;
  }
  return Explain(status);
}

absl::Status ErrorOf(const v1::Job& job) {
  constexpr std::array<std::string_view, 7> kModelStages = {"room",        "zones",    "objects",    "style",
                                                            "constraints", "cleaning", "translation"};
  const auto code = static_cast<absl::StatusCode>(job.error_code());
  // Artifacts that are taken from an earlier job are no model's answers.
  const bool taken = job.spec().has_replay() &&
                     orchestrator::StageIndex(job.stage()) < orchestrator::FirstStageOf(job.spec().replay());
  const bool of_model = code == absl::StatusCode::kDataLoss || code == absl::StatusCode::kFailedPrecondition ||
                        code == absl::StatusCode::kPermissionDenied;
  if (of_model && !taken && std::ranges::find(kModelStages, job.stage()) != kModelStages.end())
    return ModelError(job.error());
  return absl::Status(code, job.error());
}

absl::Status WaitForJob(Session& session, const std::string& id, Progress& progress) {
  RETURN_IF_ERROR(session.Watch(id, [&](const v1::JobEvent& event) { progress.See(event); }));
  ASSIGN_OR_RETURN(const v1::Job job, session.GetJob(id));
  switch (job.state()) {
    case v1::JOB_STATE_SUCCEEDED:
      return absl::OkStatus();
    case v1::JOB_STATE_CANCELLED:
      return absl::CancelledError(fmt::format("job {} was cancelled", id));
    case v1::JOB_STATE_FAILED:
      return ErrorOf(job);
    default:
      return absl::InternalError(fmt::format("job {} has not ended; see: flair jobs show {}", id, id));
  }
}

absl::StatusOr<ArtifactsByKind> StoredArtifacts(Session& session, const v1::Job& job) {
  ArtifactsByKind artifacts;
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    ASSIGN_OR_RETURN(v1::Artifact artifact, session.GetArtifact(ref.id()));
    RETURN_IF_ERROR(CheckArtifactId(artifact, "artifact " + ref.id()));
    // The first of its kind: further views come after the preview.
    artifacts.try_emplace(ref.kind(), std::move(artifact));
  }
  return artifacts;
}

absl::StatusOr<ArtifactsByKind> CollectArtifacts(Session& session, const v1::Job& job) {
  ASSIGN_OR_RETURN(ArtifactsByKind artifacts, StoredArtifacts(session, job));
  for (const v1::ArtifactKind kind : {v1::ARTIFACT_KIND_SOLVED_LAYOUT, v1::ARTIFACT_KIND_PREVIEW}) {
    if (!artifacts.contains(kind)) {
      return absl::InternalError(fmt::format("job {} succeeded without a {}", job.id(), KindName(kind)));
    }
  }
  return artifacts;
}

}  // namespace flair::cli
