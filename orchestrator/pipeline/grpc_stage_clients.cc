// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/grpc_stage_clients.h"

#include <fmt/format.h>

#include <mutex>
#include <optional>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "worker_runtime/files/sha256.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/protocol.h"

namespace flair::orchestrator {
namespace {

// All that decides its answers. A revision alone does not do: two servers may call theirs "1".
std::optional<std::string> KeyOf(const v1::GetWorkerResponse& worker) {
  if (worker.revision().empty()) return std::nullopt;
  v1::GetWorkerResponse key;
  key.set_program(worker.program());
  key.set_revision(worker.revision());
  key.set_configuration_digest(worker.configuration_digest());
  return runtime::CanonicalBytes(key);
}

// A stub with what its error messages need.
template <typename Service>
struct Stage {
  using Interface = typename Service::StubInterface;

  Stage(const char* stage_name, const StageChannel& channel)
      : name(stage_name),
        address(channel.address),
        setting(channel.setting),
        stub(Service::NewStub(channel.channel)),
        worker_stub(v1::WorkerService::NewStub(channel.channel)) {}

  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (Interface::*method)(grpc::ClientContext*, const Request&, Response*),
                               const Request& request, runtime::CallContext& call) const {
    return Explain(runtime::UnaryRequest(static_cast<Interface&>(*stub), method, request, call));
  }

  // A server of this process stays what it is; others may be replaced at any time and are asked each time.
  absl::StatusOr<std::optional<std::string>> Revision(runtime::CallContext& call) {
    if (address != StageChannel().address) return AskRevision(call);
    std::lock_guard lock(mutex);
    if (!known_revision.has_value()) {
      absl::StatusOr<std::optional<std::string>> revision = AskRevision(call);
      if (!revision.ok()) return revision;
      known_revision = *std::move(revision);
    }
    return *known_revision;
  }

  absl::StatusOr<std::optional<std::string>> AskRevision(runtime::CallContext& call) const {
    const absl::StatusOr<v1::GetWorkerResponse> worker =
        runtime::UnaryRequest(*worker_stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call);
    if (absl::IsUnimplemented(worker.status())) return std::nullopt;
    if (!worker.ok()) return Explain(worker).status();
    if (const std::string fault = runtime::ProtocolFault(*worker); !fault.empty()) {
      return absl::UnimplementedError(
          fmt::format("{} worker at {}: {}; start a version of it that does or fix {}", name, address, fault, setting));
    }
    return KeyOf(*worker);
  }

  template <typename Response>
  absl::StatusOr<Response> Explain(absl::StatusOr<Response> answer) const {
    const std::string message(answer.status().message());
    if (absl::IsUnavailable(answer.status())) {
      return absl::UnavailableError(
          fmt::format("{} worker at {} is not reachable: {}; start it or fix {}", name, address, message, setting));
    }
    if (absl::IsUnimplemented(answer.status())) {
      return absl::UnimplementedError(fmt::format(
          "{} worker at {}: the server there does not serve this call of {}{}; start one that does or fix {}", name,
          address, Service::service_full_name(), message.empty() ? "" : ": " + message, setting));
    }
    return answer;
  }

  std::string name;
  std::string address;
  std::string setting;
  std::unique_ptr<typename Service::Stub> stub;
  std::unique_ptr<v1::WorkerService::Stub> worker_stub;
  std::mutex mutex;
  std::optional<std::optional<std::string>> known_revision;
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
  absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind kind, Call& call) override {
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
