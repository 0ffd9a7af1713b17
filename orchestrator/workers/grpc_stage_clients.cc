// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/workers/grpc_stage_clients.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "orchestrator/workers/worker_call.h"

namespace flair::orchestrator {
namespace {

// Workers that one call may lose, or fail at on trial, before that is its answer: a request that ends every worker must
// not end them all.
constexpr size_t kTriedLimit = 3;

template <typename Service>
class Stage {
 public:
  Stage(WorkersOfStage& workers, absl::Duration hedge_after) : workers_(workers), hedge_after_(hedge_after) {}

  // Asks workers until one answers. A full one is no answer, nor is one that is not there; see docs/workers.md.
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(std::unique_ptr<grpc::ClientAsyncResponseReaderInterface<Response>> (
                                   Service::StubInterface::*method)(grpc::ClientContext*, const Request&,
                                                                    grpc::CompletionQueue*),
                               const Request& request, StageCall& call) const {
    std::set<WorkerId> tried;
    absl::Status failure;
    while (true) {
      const absl::StatusOr<Place> place = workers_.pool().Take(tried, call);
      if (!place.ok()) return absl::IsUnavailable(place.status()) && !failure.ok() ? failure : place.status();
      WorkerCall<Service, Request, Response> worker_call(workers_, method, request, call);
      auto& attempt = worker_call.Run(*place, tried, hedge_after_);
      if (attempt.status.ok()) {
        call.SetAnswerer(
            {attempt.place.revision, [&pool = workers_.pool(), at = attempt.place] { pool.ReportBadAnswer(at); }});
        return std::move(attempt.response);
      }
      if (VerdictOf(attempt.status) == Verdict::kGood) return attempt.status;
      for (const auto& made : worker_call.attempts()) {
        if (MayDoBetterElsewhere(made)) tried.insert(made.place.worker);
      }
      const bool full = VerdictOf(attempt.status) == Verdict::kFull;
      if (!full) failure = Explain(attempt);
      if (tried.size() >= kTriedLimit || (!full && !MayDoBetterElsewhere(attempt))) return Explain(attempt);
    }
  }

  absl::StatusOr<std::optional<std::string>> Revision(StageCall& call) const { return workers_.pool().Revision(call); }

 private:
  // A worker on trial was expected to fail.
  template <typename Attempt>
  static bool MayDoBetterElsewhere(const Attempt& attempt) {
    const Verdict verdict = VerdictOf(attempt.status);
    return verdict == Verdict::kLost || (verdict == Verdict::kFailed && attempt.place.on_trial);
  }

  template <typename Attempt>
  absl::Status Explain(const Attempt& attempt) const {
    const std::string address = attempt.connection == nullptr ? "an address" : attempt.connection->address();
    const std::string message(attempt.status.message());
    if (absl::IsUnavailable(attempt.status)) {
      return absl::UnavailableError(fmt::format("{} worker at {} is not reachable: {}; start it or fix {}",
                                                workers_.stage(), address, message, workers_.setting()));
    }
    if (absl::IsUnimplemented(attempt.status)) {
      return absl::UnimplementedError(fmt::format(
          "{} worker at {}: the server there does not serve this call of {}{}; start one that does or fix {}",
          workers_.stage(), address, Service::service_full_name(), message.empty() ? "" : ": " + message,
          workers_.setting()));
    }
    return attempt.status;
  }

  WorkersOfStage& workers_;
  const absl::Duration hedge_after_;
};

using Language = v1::LanguageService::StubInterface;
using Translator = v1::TranslatorService::StubInterface;
using Optimizer = v1::OptimizerService::StubInterface;
using Renderer = v1::RendererService::StubInterface;

class GrpcStageClients final : public StageClients {
 public:
  explicit GrpcStageClients(const StageCallers& callers)
      : language_(callers.language, callers.hedge_after),
        translator_(callers.translator, callers.hedge_after),
        optimizer_(callers.optimizer, callers.hedge_after),
        renderer_(callers.renderer, callers.hedge_after) {}

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest& request, Call& call) override {
    return language_.Ask(&Language::PrepareAsyncDescribeRoom, request, call);
  }
  absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest& request, Call& call) override {
    return language_.Ask(&Language::PrepareAsyncPlanZones, request, call);
  }
  absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest& request, Call& call) override {
    return language_.Ask(&Language::PrepareAsyncListObjects, request, call);
  }
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest& request, Call& call) override {
    return language_.Ask(&Language::PrepareAsyncChooseStyle, request, call);
  }
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest& request,
                                                              Call& call) override {
    return language_.Ask(&Language::PrepareAsyncListConstraints, request, call);
  }
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest& request,
                                                                Call& call) override {
    return language_.Ask(&Language::PrepareAsyncCleanConstraints, request, call);
  }
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request, Call& call) override {
    return translator_.Ask(&Translator::PrepareAsyncTranslate, request, call);
  }
  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest& request,
                                                                      Call& call) override {
    return optimizer_.Ask(&Optimizer::PrepareAsyncListConstraintTypes, request, call);
  }
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest& request, Call& call) override {
    return optimizer_.Ask(&Optimizer::PrepareAsyncSolve, request, call);
  }
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest& request, Call& call) override {
    return optimizer_.Ask(&Optimizer::PrepareAsyncEvaluate, request, call);
  }
  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest& request, Call& call) override {
    return renderer_.Ask(&Renderer::PrepareAsyncRender, request, call);
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

std::unique_ptr<StageClients> MakeGrpcStageClients(const StageCallers& callers) {
  return std::make_unique<GrpcStageClients>(callers);
}

}  // namespace flair::orchestrator
