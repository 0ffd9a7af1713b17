// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/testing/fake_workers.h"

#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/server.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::orchestrator {
namespace {

// Answers RPCs with the functions of StageClients of the same names.
class Fake : public runtime::Service {
 protected:
  Fake(runtime::WorkerContext& worker, StageClients& stages, const char* name)
      : Service(worker, name), stages_(stages) {}

  template <typename Request, typename Response>
  void Forward(const char* rpc,
               absl::StatusOr<Response> (StageClients::*function)(const Request&, StageClients::Call&)) {
    Unary<Request>(rpc, [this, function](const Request& request, runtime::CallContext& call) {
      StageClients::Call stage_call(call.request_id(), call.deadline(), runtime::SystemClock());
      runtime::OnCancel guard(call.cancellation(), [&] { stage_call.cancellation().Cancel(); });
      return (stages_.*function)(request, stage_call);
    });
  }

 private:
  StageClients& stages_;
};

struct FakeLanguage final : Fake {
  FakeLanguage(runtime::WorkerContext& worker, StageClients& stages)
      : Fake(worker, stages, v1::LanguageService::service_full_name()) {
    Forward("DescribeRoom", &StageClients::DescribeRoom);
    Forward("PlanZones", &StageClients::PlanZones);
    Forward("ListObjects", &StageClients::ListObjects);
    Forward("ChooseStyle", &StageClients::ChooseStyle);
    Forward("ListConstraints", &StageClients::ListConstraints);
    Forward("CleanConstraints", &StageClients::CleanConstraints);
    Forward("CompleteConstraints", &StageClients::CompleteConstraints);
  }
};

struct FakeTranslator final : Fake {
  FakeTranslator(runtime::WorkerContext& worker, StageClients& stages)
      : Fake(worker, stages, v1::TranslatorService::service_full_name()) {
    Forward("Translate", &StageClients::Translate);
  }
};

struct FakeOptimizer final : Fake {
  FakeOptimizer(runtime::WorkerContext& worker, StageClients& stages)
      : Fake(worker, stages, v1::OptimizerService::service_full_name()) {
    Forward("ListConstraintTypes", &StageClients::ListConstraintTypes);
    Forward("Solve", &StageClients::Solve);
    Forward("Evaluate", &StageClients::Evaluate);
    Forward("Resolve", &StageClients::Resolve);
  }
};

struct FakeRenderer final : Fake {
  FakeRenderer(runtime::WorkerContext& worker, StageClients& stages)
      : Fake(worker, stages, v1::RendererService::service_full_name()) {
    Forward("Render", &StageClients::Render);
  }
};

}  // namespace

// The order matters: the server stops before the resources go.
struct FakeWorkers::Worker {
  runtime::WorkerResources resources;
  std::unique_ptr<runtime::Server> server;
};

FakeWorkers::FakeWorkers(StageClients& stages) {
  channels_.language =
      Start<v1::LanguageService, FakeLanguage>("fake-language", stages, *addresses_.mutable_language());
  channels_.translator =
      Start<v1::TranslatorService, FakeTranslator>("fake-translator", stages, *addresses_.mutable_translator());
  channels_.optimizer =
      Start<v1::OptimizerService, FakeOptimizer>("fake-optimizer", stages, *addresses_.mutable_optimizer());
  channels_.renderer =
      Start<v1::RendererService, FakeRenderer>("fake-renderer", stages, *addresses_.mutable_renderer());
}

FakeWorkers::~FakeWorkers() = default;

template <typename Service, typename Fake>
StageChannel FakeWorkers::Start(const char* program, StageClients& stages, std::string& address) {
  config::v1::RuntimeConfig config;
  config.set_log_level("error");
  config.set_worker_thread_count(8);
  Worker& worker = *workers_.emplace_back(new Worker{runtime::WorkerResources(program, config), nullptr});
  std::vector<runtime::NamedService> services;
  services.push_back({Service::service_full_name(), std::make_unique<Fake>(worker.resources.context(), stages)});
  worker.server = *runtime::Server::Start({.program = program, .listen_address = "127.0.0.1:0"}, std::move(services));
  address = worker.server->address();
  return {worker.server->InProcessChannel()};
}

}  // namespace flair::orchestrator
