// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/grpc_stage_clients.h"

#include <fmt/format.h>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::orchestrator {
namespace {

// A stub with what its error messages need.
template <typename Service>
struct Stage {
  using Interface = typename Service::StubInterface;

  Stage(const char* stage_name, const StageChannel& channel)
      : name(stage_name),
        address(channel.address),
        stub(Service::NewStub(channel.channel)),
        worker_stub(v1::WorkerService::NewStub(channel.channel)) {}

  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (Interface::*method)(grpc::ClientContext*, const Request&, Response*),
                               const Request& request, runtime::CallContext& call) const {
    return Explain(runtime::UnaryRequest(static_cast<Interface&>(*stub), method, request, call));
  }

  absl::StatusOr<std::string> Revision(runtime::CallContext& call) const {
    auto answer = Explain(runtime::UnaryRequest(*worker_stub, &v1::WorkerService::StubInterface::GetWorker,
                                                v1::GetWorkerRequest(), call));
    if (absl::IsUnimplemented(answer.status())) return "";
    if (!answer.ok()) return answer.status();
    return answer->revision();
  }

  template <typename Response>
  absl::StatusOr<Response> Explain(absl::StatusOr<Response> answer) const {
    if (!absl::IsUnavailable(answer.status())) return answer;
    return absl::UnavailableError(fmt::format("{0} worker at {1} is not reachable: {2}; start it or fix stages.{0}",
                                              name, address, std::string(answer.status().message())));
  }

  std::string name;
  std::string address;
  std::unique_ptr<typename Service::Stub> stub;
  std::unique_ptr<v1::WorkerService::Stub> worker_stub;
};

using Language = v1::LanguageService::StubInterface;
using Translator = v1::TranslatorService::StubInterface;
using Optimizer = v1::OptimizerService::StubInterface;
using Renderer = v1::RendererService::StubInterface;

class GrpcStageClients final : public StageClients {
 public:
  explicit GrpcStageClients(const StageChannels& channels)
      : language_("language", channels.language),
        translator_("translator", channels.translator),
        optimizer_("optimizer", channels.optimizer),
        renderer_("renderer", channels.renderer) {}

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest& request, Call& call) override {
    return language_.Ask(&Language::DescribeRoom, request, call);
  }
  absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest& request, Call& call) override {
    return language_.Ask(&Language::PlanZones, request, call);
  }
  absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest& request, Call& call) override {
    return language_.Ask(&Language::ListObjects, request, call);
  }
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest& request, Call& call) override {
    return language_.Ask(&Language::ChooseStyle, request, call);
  }
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest& request,
                                                              Call& call) override {
    return language_.Ask(&Language::ListConstraints, request, call);
  }
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest& request,
                                                                Call& call) override {
    return language_.Ask(&Language::CleanConstraints, request, call);
  }
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request, Call& call) override {
    return translator_.Ask(&Translator::Translate, request, call);
  }
  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest& request,
                                                                      Call& call) override {
    return optimizer_.Ask(&Optimizer::ListConstraintTypes, request, call);
  }
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest& request, Call& call) override {
    return optimizer_.Ask(&Optimizer::Solve, request, call);
  }
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest& request, Call& call) override {
    return optimizer_.Ask(&Optimizer::Evaluate, request, call);
  }
  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest& request, Call& call) override {
    return renderer_.Ask(&Renderer::Render, request, call);
  }
  absl::StatusOr<std::string> Revision(v1::ArtifactKind kind, Call& call) override {
    switch (kind) {
      case v1::ARTIFACT_KIND_BRIEF:
      case v1::ARTIFACT_KIND_REPORT:
        return "";
      case v1::ARTIFACT_KIND_LAYOUT_GRAPH:
        return translator_.Revision(call);
      case v1::ARTIFACT_KIND_SOLVED_LAYOUT:
        return optimizer_.Revision(call);
      case v1::ARTIFACT_KIND_PREVIEW:
        return renderer_.Revision(call);
      default:
        return language_.Revision(call);
    }
  }

 private:
  Stage<v1::LanguageService> language_;
  Stage<v1::TranslatorService> translator_;
  Stage<v1::OptimizerService> optimizer_;
  Stage<v1::RendererService> renderer_;
};

}  // namespace

std::unique_ptr<StageClients> MakeGrpcStageClients(const StageChannels& channels) {
  return std::make_unique<GrpcStageClients>(channels);
}

}  // namespace flair::orchestrator
