// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/server.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::orchestrator {

struct TestWorkerOptions {
  std::string revision = "1";
  std::string listen_address = "127.0.0.1:0";
  int thread_count = 8;
  int queue_limit = 64;
  // Its answers are bytes that are no SolveResponse.
  bool garbage = false;
};

// An optimizer for tests behind a real socket: its Solve does what it is told and its answer names it.
class TestWorker {
 public:
  using Solve = std::function<absl::Status(runtime::CallContext& call)>;
  using Options = TestWorkerOptions;

  explicit TestWorker(
      Solve solve = [](runtime::CallContext&) { return absl::OkStatus(); }, const Options& options = {})
      : solve_(std::move(solve)), resources_("test-optimizer", RuntimeOf(options)) {
    std::vector<runtime::NamedService> services;
    services.push_back({v1::OptimizerService::service_full_name(), std::make_unique<Service>(*this, options.garbage)});
    auto server = runtime::Server::Start(
        {.program = "test-optimizer", .revision = options.revision, .listen_address = options.listen_address},
        std::move(services));
    if (server.ok()) server_ = *std::move(server);
  }

  // Empty when it could not listen.
  std::string address() const { return server_ == nullptr ? "" : server_->address(); }
  int calls() const { return calls_; }
  // Says that it does not serve, lets calls end, is gone.
  void Drain() { server_->Shutdown(absl::Seconds(60)); }
  // Is gone, with all calls.
  void Kill() { server_->Shutdown(absl::ZeroDuration()); }

 private:
  struct Service final : runtime::Service {
    Service(TestWorker& worker, bool garbage)
        : runtime::Service(worker.resources_.context(), v1::OptimizerService::service_full_name()) {
      if (garbage) {
        Unary<v1::SolveRequest>(
            "Solve", [](const v1::SolveRequest&, runtime::CallContext&) -> absl::StatusOr<v1::GetJobRequest> {
              v1::GetJobRequest answer;
              answer.set_job_id("\x0f");
              return answer;
            });
        return;
      }
      Unary<v1::SolveRequest>(
          "Solve", [&worker](const v1::SolveRequest&, runtime::CallContext& call) -> absl::StatusOr<v1::SolveResponse> {
            ++worker.calls_;
            v1::SolveResponse response;
            response.mutable_producer()->set_program(worker.address());
            RETURN_IF_ERROR(worker.solve_(call));
            return response;
          });
    }
  };

  static config::v1::RuntimeConfig RuntimeOf(const Options& options) {
    config::v1::RuntimeConfig runtime;
    runtime.set_log_level("error");
    runtime.set_worker_thread_count(options.thread_count);
    runtime.set_queue_limit(options.queue_limit);
    return runtime;
  }

  const Solve solve_;
  std::atomic<int> calls_ = 0;
  // The order matters: the server stops before the resources go.
  runtime::WorkerResources resources_;
  std::unique_ptr<runtime::Server> server_;
};

}  // namespace flair::orchestrator
