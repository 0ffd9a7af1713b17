// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "worker_runtime/clock/clock.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::config::v1 {
class RuntimeConfig;
}  // namespace flair::config::v1

namespace flair::v1 {
class Producer;
enum Capability : int;
}  // namespace flair::v1

namespace spdlog {
class logger;
}  // namespace spdlog

namespace flair::runtime {

// What every service is given. The references outlive the service. Each service has an executor of its own: a service
// that calls another one in the same process must not wait for a thread that it holds itself.
struct WorkerContext {
  Clock& clock;
  Metrics& metrics;
  BoundedExecutor& executor;
  // Of the calls that the server answers.
  RpcMetrics& rpc_metrics;
  // Shared because spdlog's sinks and loggers are; never null.
  std::shared_ptr<spdlog::logger> logger;
  // What the large messages may take that are being answered; see ServerCall.
  std::shared_ptr<std::atomic<int64_t>> unfolded_bytes = std::make_shared<std::atomic<int64_t>>(0);
  // Names the data that the service answers from, beyond the program itself; set by the service while it is made. Two
  // servers whose answers may differ must differ here or in their build.
  std::string revision = "";
  // What the program was built from (BuildName).
  std::string build = "";
  // What the service promises beyond what every server of its stage must; set by the service while it is made.
  std::vector<v1::Capability> capabilities = {};
  // Names in certificates of those that may call; of anybody's when empty.
  std::vector<std::string> client_names = {};
};

// SHA-256 of the worker's revision, see Producer.configuration_digest; empty when it has none.
std::string ConfigurationDigest(const WorkerContext& worker);

// Fills in what every answer of the worker says of its producer: build and configuration.
void SignProducer(const WorkerContext& worker, v1::Producer& producer);

// Owns what a WorkerContext refers to. Stop the server and destroy the service before it.
class WorkerResources {
 public:
  // `program` names the log lines, such as "flair-optimizer".
  WorkerResources(const std::string& program, const config::v1::RuntimeConfig& config, Clock& clock = SystemClock(),
                  Metrics& metrics = NullMetrics());

  WorkerContext& context() { return context_; }
  const std::string& program() const { return program_; }

 private:
  const std::string program_;
  BoundedExecutor executor_;
  RpcMetrics rpc_metrics_;
  WorkerContext context_;
};

}  // namespace flair::runtime
