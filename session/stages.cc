// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/stages.h"

#include <grpcpp/channel.h>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {

using runtime::CallContext;
using runtime::UnaryRequest;

namespace {

template <typename Request>
const Request& Named(Request& request) {
  request.set_request_id("flair-session");
  return request;
}

}  // namespace

// Calls under way keep theirs.
struct Stages::Designer {
  explicit Designer(const Channels& channels)
      : orchestrator(v1::OrchestratorService::NewStub(channels.orchestrator)),
        translator(v1::TranslatorService::NewStub(channels.translator)) {}
  const std::unique_ptr<v1::OrchestratorService::Stub> orchestrator;
  const std::unique_ptr<v1::TranslatorService::Stub> translator;
};

struct Stages::Stubs {
  std::unique_ptr<v1::OptimizerService::Stub> optimizer;
  std::unique_ptr<v1::RendererService::Stub> renderer;
};

Stages::Stages(const Channels& channels)
    : stubs_(new Stubs{.optimizer = v1::OptimizerService::NewStub(channels.optimizer),
                       .renderer = v1::RendererService::NewStub(channels.renderer)}),
      designer_(std::make_shared<Designer>(channels)) {}
Stages::~Stages() = default;

void Stages::DesignBy(const Channels& channels) {
  const auto designer = std::make_shared<Designer>(channels);
  const std::lock_guard lock(mutex_);
  designer_ = designer;
}

std::shared_ptr<Stages::Designer> Stages::DesignerNow() {
  const std::lock_guard lock(mutex_);
  return designer_;
}

absl::StatusOr<v1::SolveResponse> Stages::Solve(v1::SolveRequest request, CallContext& call) {
  return UnaryRequest(*stubs_->optimizer, &v1::OptimizerService::StubInterface::Solve, Named(request), call);
}
absl::StatusOr<v1::ResolveResponse> Stages::Resolve(v1::ResolveRequest request, CallContext& call) {
  return UnaryRequest(*stubs_->optimizer, &v1::OptimizerService::StubInterface::Resolve, Named(request), call);
}
absl::StatusOr<v1::EvaluateResponse> Stages::Evaluate(v1::EvaluateRequest request, CallContext& call) {
  return UnaryRequest(*stubs_->optimizer, &v1::OptimizerService::StubInterface::Evaluate, Named(request), call);
}
absl::StatusOr<v1::ConstraintCatalog> Stages::Catalog(CallContext& call) {
  const std::lock_guard lock(mutex_);
  if (!catalog_.has_value()) {
    ASSIGN_OR_RETURN(v1::ListConstraintTypesResponse response,
                     UnaryRequest(*stubs_->optimizer, &v1::OptimizerService::StubInterface::ListConstraintTypes,
                                  v1::ListConstraintTypesRequest(), call));
    catalog_ = std::move(*response.mutable_catalog());
  }
  return *catalog_;
}
absl::StatusOr<v1::TranslateResponse> Stages::Translate(v1::TranslateRequest request, CallContext& call) {
  return UnaryRequest(*DesignerNow()->translator, &v1::TranslatorService::StubInterface::Translate, Named(request),
                      call);
}
absl::StatusOr<v1::RenderResponse> Stages::Render(v1::RenderRequest request, CallContext& call) {
  return UnaryRequest(*stubs_->renderer, &v1::RendererService::StubInterface::Render, Named(request), call);
}
absl::StatusOr<v1::ExportSceneResponse> Stages::ExportScene(v1::ExportSceneRequest request, CallContext& call) {
  return UnaryRequest(*stubs_->renderer, &v1::RendererService::StubInterface::ExportScene, Named(request), call);
}
absl::StatusOr<v1::DrawPlanPartsResponse> Stages::DrawPlanParts(v1::DrawPlanPartsRequest request, CallContext& call) {
  return UnaryRequest(*stubs_->renderer, &v1::RendererService::StubInterface::DrawPlanParts, Named(request), call);
}

absl::StatusOr<v1::Job> Stages::CreateJob(const v1::CreateJobRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(
      v1::CreateJobResponse response,
      UnaryRequest(*DesignerNow()->orchestrator, &v1::OrchestratorService::StubInterface::CreateJob, request, call));
  return std::move(*response.mutable_job());
}
absl::StatusOr<v1::Job> Stages::GetJob(const std::string& id, CallContext& call) {
  v1::GetJobRequest request;
  request.set_job_id(id);
  ASSIGN_OR_RETURN(
      v1::GetJobResponse response,
      UnaryRequest(*DesignerNow()->orchestrator, &v1::OrchestratorService::StubInterface::GetJob, request, call));
  return std::move(*response.mutable_job());
}
absl::StatusOr<std::vector<v1::Job>> Stages::ListJobs(CallContext& call) {
  v1::ListJobsRequest request;
  request.set_page_size(1000);
  ASSIGN_OR_RETURN(
      const v1::ListJobsResponse response,
      UnaryRequest(*DesignerNow()->orchestrator, &v1::OrchestratorService::StubInterface::ListJobs, request, call));
  return std::vector<v1::Job>(response.jobs().begin(), response.jobs().end());
}
absl::Status Stages::CancelJob(const std::string& id, CallContext& call) {
  v1::CancelJobRequest request;
  request.set_job_id(id);
  return UnaryRequest(*DesignerNow()->orchestrator, &v1::OrchestratorService::StubInterface::CancelJob, request, call)
      .status();
}
absl::StatusOr<v1::Artifact> Stages::GetArtifact(const std::string& id, CallContext& call) {
  v1::GetArtifactRequest request;
  request.set_artifact_id(id);
  ASSIGN_OR_RETURN(
      v1::GetArtifactResponse response,
      UnaryRequest(*DesignerNow()->orchestrator, &v1::OrchestratorService::StubInterface::GetArtifact, request, call));
  return std::move(*response.mutable_artifact());
}

absl::Status Stages::WatchJob(const std::string& id, int64_t after_sequence,
                              const std::function<void(const v1::JobEvent&)>& see, CallContext& call) {
  v1::WatchJobRequest request;
  request.set_job_id(id);
  request.set_after_sequence(after_sequence);
  grpc::ClientContext context;
  const runtime::OnCancel guard(call.cancellation(), [&context] { context.TryCancel(); });
  const std::shared_ptr<Designer> designer = DesignerNow();
  const auto reader = designer->orchestrator->WatchJob(&context, request);
  v1::WatchJobResponse response;
  while (reader->Read(&response)) see(response.event());
  return runtime::FromGrpcStatus(reader->Finish(), context);
}

}  // namespace flair::session
