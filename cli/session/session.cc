// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/session.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "cli/input/service_flags.h"
#include "fmt/format.h"
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
                                                       const StageFlags& stages,
                                                       const config::v1::OrchestratorConfig& orchestrator) {
  if (address.empty()) {
    absl::StatusOr<std::unique_ptr<EmbeddedServices>> services =
        EmbeddedServices::Start(DefaultStorePath(), llm, stages, orchestrator);
    if (!services.ok()) return services.status();
    std::shared_ptr<grpc::Channel> channel = (*services)->orchestrator();
    return std::unique_ptr<Session>(new Session(*std::move(services), std::move(channel), "this process"));
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

}  // namespace flair::cli
