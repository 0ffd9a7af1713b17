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

class MetricsEndpoint;
class ProcessMetrics;
class PrometheusMetrics;

// What Assemble fills: the services of one program.
class Worker {
 public:
  Worker(const std::string& program, const config::v1::RuntimeConfig& config);
  ~Worker();

  WorkerContext& context() { return resources_.context(); }

  // Serves `service` once Assemble has returned. `name` is its full name: v1::OptimizerService::service_full_name().
  void Serve(const std::string& name, std::unique_ptr<grpc::Service> service) {
    services_.push_back({name, std::move(service)});
  }

  // Called when the stop begins, before running calls are waited for: the place to end endless streams.
  void OnStop(std::function<void()> callback) { stop_callbacks_.push_back(std::move(callback)); }

  // Listens; then says "listening on ADDRESS" on standard output, and "metrics on ADDRESS" where it has such.
  absl::Status Start();

  // Stops in order: callbacks of OnStop, no new calls, running calls (config's drain_seconds), server and services,
  // metrics.
  void Stop();

 private:
  absl::Status StartMetrics();

  const config::v1::RuntimeConfig config_;
  // Null when nobody can ask for figures.
  const std::unique_ptr<PrometheusMetrics> metrics_;
  WorkerResources resources_;
  std::vector<NamedService> services_;
  std::vector<std::function<void()>> stop_callbacks_;
  std::unique_ptr<Server> server_;
  std::unique_ptr<ProcessMetrics> process_metrics_;
  std::unique_ptr<MetricsEndpoint> metrics_endpoint_;
};

}  // namespace flair::runtime
