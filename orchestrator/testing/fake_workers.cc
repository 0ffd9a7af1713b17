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

// Answers one RPC with the function of StageClients of the same name.
template <typename Request, typename Response>
grpc::ServerUnaryReactor* Forward(runtime::WorkerContext& worker, StageClients& stages, const char* rpc,
                                  grpc::CallbackServerContext* context, const Request* request, Response* response,
                                  absl::StatusOr<Response> (StageClients::*function)(const Request&,
                                                                                     StageClients::Call&)) {
  return runtime::StartUnary(
      worker, rpc, {}, *context, [&stages, request, response, function](runtime::CallContext& call) -> absl::Status {
        StageClients::Call stage_call(call.request_id(), call.deadline(), runtime::SystemClock());
        runtime::OnCancel guard(call.cancellation(), [&] { stage_call.cancellation().Cancel(); });
        absl::StatusOr<Response> answer = (stages.*function)(*request, stage_call);
        if (answer.ok()) *response = *std::move(answer);
        return answer.status();
      });
}

class FakeLanguage final : public v1::LanguageService::CallbackService {
 public:
  FakeLanguage(runtime::WorkerContext& worker, StageClients& stages) : worker_(worker), stages_(stages) {}
  grpc::ServerUnaryReactor* DescribeRoom(grpc::CallbackServerContext* context, const v1::DescribeRoomRequest* request,
                                         v1::DescribeRoomResponse* response) override {
    return Forward(worker_, stages_, "DescribeRoom", context, request, response, &StageClients::DescribeRoom);
  }
  grpc::ServerUnaryReactor* PlanZones(grpc::CallbackServerContext* context, const v1::PlanZonesRequest* request,
                                      v1::PlanZonesResponse* response) override {
    return Forward(worker_, stages_, "PlanZones", context, request, response, &StageClients::PlanZones);
  }
  grpc::ServerUnaryReactor* ListObjects(grpc::CallbackServerContext* context, const v1::ListObjectsRequest* request,
                                        v1::ListObjectsResponse* response) override {
    return Forward(worker_, stages_, "ListObjects", context, request, response, &StageClients::ListObjects);
  }
  grpc::ServerUnaryReactor* ChooseStyle(grpc::CallbackServerContext* context, const v1::ChooseStyleRequest* request,
                                        v1::ChooseStyleResponse* response) override {
    return Forward(worker_, stages_, "ChooseStyle", context, request, response, &StageClients::ChooseStyle);
  }
  grpc::ServerUnaryReactor* ListConstraints(grpc::CallbackServerContext* context,
                                            const v1::ListConstraintsRequest* request,
                                            v1::ListConstraintsResponse* response) override {
    return Forward(worker_, stages_, "ListConstraints", context, request, response, &StageClients::ListConstraints);
  }
  grpc::ServerUnaryReactor* CleanConstraints(grpc::CallbackServerContext* context,
                                             const v1::CleanConstraintsRequest* request,
                                             v1::CleanConstraintsResponse* response) override {
    return Forward(worker_, stages_, "CleanConstraints", context, request, response, &StageClients::CleanConstraints);
  }
  grpc::ServerUnaryReactor* CompleteConstraints(grpc::CallbackServerContext* context,
                                                const v1::CompleteConstraintsRequest* request,
                                                v1::CompleteConstraintsResponse* response) override {
    return Forward(worker_, stages_, "CompleteConstraints", context, request, response,
                   &StageClients::CompleteConstraints);
  }

 private:
  runtime::WorkerContext& worker_;
  StageClients& stages_;
};

class FakeTranslator final : public v1::TranslatorService::CallbackService {
 public:
  FakeTranslator(runtime::WorkerContext& worker, StageClients& stages) : worker_(worker), stages_(stages) {}
  grpc::ServerUnaryReactor* Translate(grpc::CallbackServerContext* context, const v1::TranslateRequest* request,
                                      v1::TranslateResponse* response) override {
    return Forward(worker_, stages_, "Translate", context, request, response, &StageClients::Translate);
  }

 private:
  runtime::WorkerContext& worker_;
  StageClients& stages_;
};

class FakeOptimizer final : public v1::OptimizerService::CallbackService {
 public:
  FakeOptimizer(runtime::WorkerContext& worker, StageClients& stages) : worker_(worker), stages_(stages) {}
  grpc::ServerUnaryReactor* ListConstraintTypes(grpc::CallbackServerContext* context,
                                                const v1::ListConstraintTypesRequest* request,
                                                v1::ListConstraintTypesResponse* response) override {
    return Forward(worker_, stages_, "ListConstraintTypes", context, request, response,
                   &StageClients::ListConstraintTypes);
  }
  grpc::ServerUnaryReactor* Solve(grpc::CallbackServerContext* context, const v1::SolveRequest* request,
                                  v1::SolveResponse* response) override {
    return Forward(worker_, stages_, "Solve", context, request, response, &StageClients::Solve);
  }
  grpc::ServerUnaryReactor* Evaluate(grpc::CallbackServerContext* context, const v1::EvaluateRequest* request,
                                     v1::EvaluateResponse* response) override {
    return Forward(worker_, stages_, "Evaluate", context, request, response, &StageClients::Evaluate);
  }

 private:
  runtime::WorkerContext& worker_;
  StageClients& stages_;
};

class FakeRenderer final : public v1::RendererService::CallbackService {
 public:
  FakeRenderer(runtime::WorkerContext& worker, StageClients& stages) : worker_(worker), stages_(stages) {}
  grpc::ServerUnaryReactor* Render(grpc::CallbackServerContext* context, const v1::RenderRequest* request,
                                   v1::RenderResponse* response) override {
    return Forward(worker_, stages_, "Render", context, request, response, &StageClients::Render);
  }

 private:
  runtime::WorkerContext& worker_;
  StageClients& stages_;
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
