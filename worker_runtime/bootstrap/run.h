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
#include "worker_runtime/config/config_reader.h"
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

// What a program says about itself.
struct Program {
  // Such as "flair-optimizer".
  std::string name;
  // One sentence, such as "Serves flair.v1.OptimizerService: places objects."
  std::string summary;
  // BuildName(), for all but tests.
  std::string build = "";
};

namespace internal {
int RunProgram(int argc, char** argv, const Program& program, google::protobuf::Message& config,
               const std::function<const config::v1::RuntimeConfig&()>& runtime,
               const std::function<void(ConfigChecker&)>& check, const std::function<absl::Status(Worker&)>& assemble);
}  // namespace internal

// The whole main of a program: reads the config file that is its one argument, calls
//   absl::Status assemble(const Config&, Worker&)
// serves until SIGTERM or SIGINT, then stops in order; a second signal ends it at once. `check`, when given, is
//   void check(const Config&, ConfigChecker&)
// and reports bad fields of the program's own. Exit codes: 0 stopped when told to, 1 could not serve, 2 bad arguments
// or config.
template <typename Config, typename Assemble, typename Check>
int Run(int argc, char** argv, const Program& program, const Assemble& assemble, const Check& check) {
  Config config;
  return internal::RunProgram(
      argc, argv, program, config, [&]() -> const config::v1::RuntimeConfig& { return config.runtime(); },
      [&](ConfigChecker& checker) { check(config, checker); },
      [&](Worker& worker) -> absl::Status { return assemble(config, worker); });
}

template <typename Config, typename Assemble>
int Run(int argc, char** argv, const Program& program, const Assemble& assemble) {
  return Run<Config>(argc, argv, program, assemble, [](const Config&, ConfigChecker&) {});
}

// The main of a program with one service, `Rpcs`, which make(config, worker context) returns, or why not.
template <typename Config, typename Rpcs, typename Make, typename Check>
int RunService(int argc, char** argv, const Program& program, const Make& make, const Check& check) {
  const auto assemble = [&](const Config& config, Worker& worker) {
    auto service = make(config, worker.context());
    if (service.ok()) worker.Serve(Rpcs::service_full_name(), *std::move(service));
    return service.status();
  };
  return Run<Config>(argc, argv, program, assemble, check);
}

}  // namespace flair::runtime
