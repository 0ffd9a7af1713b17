// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

#include "absl/time/clock.h"
#include "tests/security/attacks.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::testing {
namespace {

using Stub = v1::OrchestratorService::StubInterface;

constexpr absl::Duration kCallPatience = absl::Minutes(3);

template <typename Reader, typename Response>
absl::Status ReadToTheEnd(Reader reader, Response response) {
  while (reader->Read(&response)) {
  }
  return runtime::FromGrpcStatus(reader->Finish());
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

}  // namespace

OrchestratorCaller::OrchestratorCaller(const std::string& address, const runtime::ChannelOptions& options) {
  const auto channel = runtime::MakeChannel(address, v1::OrchestratorService::service_full_name(), options);
  if (!channel.ok()) throw std::runtime_error(std::string(channel.status().message()));
  stub_ = v1::OrchestratorService::NewStub(*channel);
}

template <typename Request, typename Response>
absl::StatusOr<Response> OrchestratorCaller::Ask(Method<Request, Response> method, const Request& request) {
  runtime::CallContext call;
  return runtime::UnaryRequest(*stub_, method, request, call, absl::Now() + kCallPatience);
}

absl::StatusOr<v1::Job> OrchestratorCaller::CreateJob(const std::string& text, const std::string& request_id) {
  v1::CreateJobRequest request;
  request.set_request_id(request_id);
  request.mutable_spec()->mutable_brief()->set_text(text);
  request.mutable_spec()->mutable_render_options()->set_size_px(256);
  ASSIGN_OR_RETURN(const auto response, Ask(&Stub::CreateJob, request));
  return response.job();
}

absl::StatusOr<v1::Job> OrchestratorCaller::EndOf(const std::string& job_id) {
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + kCallPatience));
  const absl::Status watched =
      ReadToTheEnd(stub_->WatchJob(&context, OfJob<v1::WatchJobRequest>(job_id)), v1::WatchJobResponse());
  if (!watched.ok()) return watched;
  ASSIGN_OR_RETURN(const auto response, Ask(&Stub::GetJob, OfJob<v1::GetJobRequest>(job_id)));
  return response.job();
}

absl::StatusOr<v1::Batch> OrchestratorCaller::CreateBatch(const std::string& text, const std::string& request_id,
                                                          int job_count) {
  v1::CreateBatchRequest request;
  request.set_request_id(request_id);
  for (int i = 0; i < job_count; ++i) {
    v1::JobSpec& spec = *request.add_specs();
    spec.mutable_brief()->set_text(text);
    spec.mutable_render_options()->set_size_px(256);
  }
  ASSIGN_OR_RETURN(const auto response, Ask(&Stub::CreateBatch, request));
  return response.batch();
}

absl::StatusOr<v1::ListJobsResponse> OrchestratorCaller::ListJobs() {
  return Ask(&Stub::ListJobs, v1::ListJobsRequest());
}

absl::StatusOr<v1::ListBatchesResponse> OrchestratorCaller::ListBatches() {
  return Ask(&Stub::ListBatches, v1::ListBatchesRequest());
}

std::map<std::string, absl::Status> OrchestratorCaller::AskAbout(const std::string& job_id, const std::string& batch_id,
                                                                 const std::string& artifact_id) {
  std::map<std::string, absl::Status> answers;
  grpc::ClientContext of_job;
  of_job.set_deadline(absl::ToChronoTime(absl::Now() + kCallPatience));
  grpc::ClientContext of_batch;
  of_batch.set_deadline(absl::ToChronoTime(absl::Now() + kCallPatience));
  answers["WatchJob"] =
      ReadToTheEnd(stub_->WatchJob(&of_job, OfJob<v1::WatchJobRequest>(job_id)), v1::WatchJobResponse());
  answers["WatchBatch"] =
      ReadToTheEnd(stub_->WatchBatch(&of_batch, OfBatch<v1::WatchBatchRequest>(batch_id)), v1::WatchBatchResponse());
  answers["GetJob"] = Ask(&Stub::GetJob, OfJob<v1::GetJobRequest>(job_id)).status();
  answers["CancelJob"] = Ask(&Stub::CancelJob, OfJob<v1::CancelJobRequest>(job_id)).status();
  answers["GetBatch"] = Ask(&Stub::GetBatch, OfBatch<v1::GetBatchRequest>(batch_id)).status();
  answers["PauseBatch"] = Ask(&Stub::PauseBatch, OfBatch<v1::PauseBatchRequest>(batch_id)).status();
  answers["ResumeBatch"] = Ask(&Stub::ResumeBatch, OfBatch<v1::ResumeBatchRequest>(batch_id)).status();
  answers["CancelBatch"] = Ask(&Stub::CancelBatch, OfBatch<v1::CancelBatchRequest>(batch_id)).status();
  answers["RetryBatch"] = Ask(&Stub::RetryBatch, OfBatch<v1::RetryBatchRequest>(batch_id)).status();
  answers["AddToBatch"] = Ask(&Stub::AddToBatch, OfBatch<v1::AddToBatchRequest>(batch_id)).status();
  v1::GetArtifactRequest artifact;
  artifact.set_artifact_id(artifact_id);
  answers["GetArtifact"] = Ask(&Stub::GetArtifact, artifact).status();
  v1::CreateJobRequest replay;
  replay.set_request_id("replay-of-" + job_id.substr(0, 40));
  replay.mutable_spec()->mutable_brief()->set_text("A bedroom that is 3m x 4m.");
  replay.mutable_spec()->mutable_replay()->set_job_id(job_id);
  answers["CreateJob with replay"] = Ask(&Stub::CreateJob, replay).status();
  // Last, since somebody may be allowed to.
  answers["DeleteJob"] = Ask(&Stub::DeleteJob, OfJob<v1::DeleteJobRequest>(job_id)).status();
  answers["DeleteBatch"] = Ask(&Stub::DeleteBatch, OfBatch<v1::DeleteBatchRequest>(batch_id)).status();
  return answers;
}

std::map<std::string, absl::Status> OrchestratorCaller::AskForAny() {
  std::map<std::string, absl::Status> answers;
  answers["ListJobs"] = ListJobs().status();
  answers["ListBatches"] = ListBatches().status();
  answers["GetCluster"] = Ask(&Stub::GetCluster, v1::GetClusterRequest()).status();
  answers["CreateJob"] = CreateJob("A bedroom that is 3m x 4m.", "any-job").status();
  answers["CreateBatch"] = CreateBatch("A bedroom that is 3m x 4m.", "any-batch").status();
  return answers;
}

}  // namespace flair::testing
