// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/stage_passage.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// A caller who sets no deadline is not waited for longer.
constexpr absl::Duration kLongest = absl::Minutes(10);

class StagePassage final : public runtime::Service {
 public:
  StagePassage(const std::string& name, StageClients& clients, AccessControl& access, runtime::WorkerContext& worker)
      : Service(worker, name), clients_(clients), access_(access) {}

  template <typename Request, typename Response>
  StagePassage& Pass(const std::string& rpc,
                     absl::StatusOr<Response> (StageClients::*method)(const Request&, StageCall&)) {
    Unary<Request>(rpc, [this, method](const Request& request, runtime::CallContext& call) {
      StageCall stage(call.request_id(), std::min(call.deadline(), worker_.clock.Now() + kLongest), worker_.clock);
      const runtime::OnCancel pass_on(call.cancellation(), [&stage] { stage.cancellation().Cancel(); });
      return (clients_.*method)(request, stage);
    });
    return *this;
  }

 private:
  absl::Status Admit(grpc::CallbackServerContext& context, runtime::CallContext& call) override {
    RETURN_IF_ERROR(runtime::Service::Admit(context, call));
    ASSIGN_OR_RETURN(Caller caller, access_.Admit(runtime::AuthorizationOf(context)));
    call.set_caller({caller.name, caller});
    return absl::OkStatus();
  }

  StageClients& clients_;
  AccessControl& access_;
};

}  // namespace

std::vector<runtime::NamedService> MakeStagePassages(StageClients& clients, AccessControl& access,
                                                     runtime::WorkerContext& worker) {
  std::vector<runtime::NamedService> services;
  const auto add = [&](const std::string& name) -> StagePassage& {
    auto passage = std::make_unique<StagePassage>(name, clients, access, worker);
    StagePassage& added = *passage;
    services.push_back({name, std::move(passage)});
    return added;
  };
  add(v1::TranslatorService::service_full_name()).Pass("Translate", &StageClients::Translate);
  add(v1::OptimizerService::service_full_name())
      .Pass("ListConstraintTypes", &StageClients::ListConstraintTypes)
      .Pass("Solve", &StageClients::Solve)
      .Pass("Resolve", &StageClients::Resolve)
      .Pass("Evaluate", &StageClients::Evaluate);
  add(v1::RendererService::service_full_name())
      .Pass("Render", &StageClients::Render)
      .Pass("ExportScene", &StageClients::ExportScene)
      .Pass("DrawPlanParts", &StageClients::DrawPlanParts);
  return services;
}

}  // namespace flair::orchestrator
