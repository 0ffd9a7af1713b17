// SPDX-License-Identifier: GPL-3.0-or-later
// Orchestrator: what it must not take, and what it does not have.
#include <grpcpp/client_context.h>

#include "absl/time/clock.h"
#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

// The id of no artifact and no job.
constexpr char kNowhere[] = "0000000000000000000000000000000000000000000000000000000000000000";

Finding IsNotFound(const std::string& sent, const absl::Status& status) {
  if (absl::IsNotFound(status)) return Kept();
  return Broken(sent + " of an id that is not there", status.ok() ? "OK" : StatusText(status), "NOT_FOUND");
}

template <typename Response, typename Request>
void AddUnknown(const Request& request, Checks& checks) {
  const std::string rpc = RpcName(request);
  checks.push_back({rpc + " of an id that is not there is NOT_FOUND", Promise::kErrors, [request, rpc](Target& target) {
                      return IsNotFound(rpc, target.Ask<Response>(request).status());
                    }});
}

Finding WatchOfNoJob(Target& target) {
  const auto stub = v1::OrchestratorService::NewStub(target.channel());
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + target.options().patience));
  v1::WatchJobRequest request;
  request.set_job_id(kNowhere);
  const auto reader = stub->WatchJob(&context, request);
  v1::WatchJobResponse response;
  while (reader->Read(&response)) {
  }
  return IsNotFound("WatchJob", runtime::FromGrpcStatus(reader->Finish()));
}

template <typename Message>
Message WithJob() {
  Message message;
  message.set_job_id(kNowhere);
  return message;
}

template <typename Message>
Message WithBatch() {
  Message message;
  message.set_batch_id(kNowhere);
  return message;
}

}  // namespace

void AddOrchestratorRefusals(Checks& checks) {
  v1::GetArtifactRequest artifact;
  artifact.set_artifact_id(kNowhere);
  AddUnknown<v1::GetJobResponse>(WithJob<v1::GetJobRequest>(), checks);
  AddUnknown<v1::CancelJobResponse>(WithJob<v1::CancelJobRequest>(), checks);
  AddUnknown<v1::DeleteJobResponse>(WithJob<v1::DeleteJobRequest>(), checks);
  AddUnknown<v1::GetBatchResponse>(WithBatch<v1::GetBatchRequest>(), checks);
  AddUnknown<v1::AddToBatchResponse>(WithBatch<v1::AddToBatchRequest>(), checks);
  AddUnknown<v1::PauseBatchResponse>(WithBatch<v1::PauseBatchRequest>(), checks);
  AddUnknown<v1::ResumeBatchResponse>(WithBatch<v1::ResumeBatchRequest>(), checks);
  AddUnknown<v1::CancelBatchResponse>(WithBatch<v1::CancelBatchRequest>(), checks);
  AddUnknown<v1::RetryBatchResponse>(WithBatch<v1::RetryBatchRequest>(), checks);
  AddUnknown<v1::DeleteBatchResponse>(WithBatch<v1::DeleteBatchRequest>(), checks);
  AddUnknown<v1::GetArtifactResponse>(artifact, checks);
  checks.push_back({"WatchJob of an id that is not there is NOT_FOUND", Promise::kErrors, WatchOfNoJob});

  using Job = v1::CreateJobRequest;
  Job job;
  job.set_request_id("contract-refusals");
  *job.mutable_spec()->mutable_brief() = BedroomBrief();
  AddRefusals<v1::CreateJobResponse, Job>(
      job,
      {{"no request_id", "request_id", [](Job& request) { request.clear_request_id(); }},
       {"a request_id of 129 characters", "request_id",
        [](Job& request) { request.set_request_id(std::string(129, 'a')); }},
       {"a brief without text", "brief.text",
        [](Job& request) { request.mutable_spec()->mutable_brief()->clear_text(); }},
       {"a seed below zero", "brief.seed", [](Job& request) { request.mutable_spec()->mutable_brief()->set_seed(-1); }},
       {"solve options out of range", "solve_options.max_restart_count",
        [](Job& request) { request.mutable_spec()->mutable_solve_options()->set_max_restart_count(0); }},
       {"render options out of range", "render_options.size_px",
        [](Job& request) { request.mutable_spec()->mutable_render_options()->set_size_px(9); }}},
      checks);
  v1::CreateBatchRequest empty;
  empty.set_request_id("contract-refusals");
  AddRefusals<v1::CreateBatchResponse, v1::CreateBatchRequest>(
      empty, {{"no jobs", "specs", [](v1::CreateBatchRequest&) {}}}, checks);
  using List = v1::ListJobsRequest;
  AddRefusals<v1::ListJobsResponse, List>(
      List(),
      {{"a page size below zero", "page_size", [](List& request) { request.set_page_size(-1); }},
       {"a page size of 1001", "page_size", [](List& request) { request.set_page_size(1001); }}},
      checks);
}

}  // namespace flair::contract
