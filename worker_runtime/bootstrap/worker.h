// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "flair/config/v1/runtime_config.pb.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/server.h"

namespace flair::runtime {

// What Assemble fills: the services of one program.
class Worker {
 public:
  Worker(const std::string& program, const config::v1::RuntimeConfig& config)
      : config_(config), resources_(program, config) {}

  WorkerContext& context() { return resources_.context(); }

  // Serves `service` once Assemble has returned. `name` is its full name: v1::OptimizerService::service_full_name().
  void Serve(const std::string& name, std::unique_ptr<grpc::Service> service) {
    services_.push_back({name, std::move(service)});
  }

  // Called when the stop begins, before running calls are waited for: the place to end endless streams.
  void OnStop(std::function<void()> callback) { stop_callbacks_.push_back(std::move(callback)); }

  // Listens; then says "listening on ADDRESS" on standard output.
  absl::Status Start();

  // Stops in order: callbacks of OnStop, no new calls, running calls (config's drain_seconds), server and services.
  void Stop();

 private:
  const config::v1::RuntimeConfig config_;
  WorkerResources resources_;
  std::vector<NamedService> services_;
  std::vector<std::function<void()>> stop_callbacks_;
  std::unique_ptr<Server> server_;
};

}  // namespace flair::runtime
