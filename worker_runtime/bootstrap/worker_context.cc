// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/worker_context.h"

#include <algorithm>
#include <thread>

#include "flair/config/v1/runtime_config.pb.h"
#include "flair/v1/provenance.pb.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/logging/log.h"

namespace flair::runtime {
namespace {

int ThreadLimit(const config::v1::RuntimeConfig& config) {
  if (config.worker_thread_count() > 0) return config.worker_thread_count();
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int QueueLimit(const config::v1::RuntimeConfig& config) { return config.queue_limit() > 0 ? config.queue_limit() : 64; }

}  // namespace

std::string ConfigurationDigest(const WorkerContext& worker) {
  return worker.revision.empty() ? "" : Sha256Hex(worker.revision);
}

void SignProducer(const WorkerContext& worker, v1::Producer& producer) {
  producer.set_build(worker.build);
  producer.set_configuration_digest(ConfigurationDigest(worker));
}

WorkerResources::WorkerResources(const std::string& program, const config::v1::RuntimeConfig& config, Clock& clock,
                                 Metrics& metrics)
    : program_(program),
      executor_(ThreadLimit(config), QueueLimit(config)),
      rpc_metrics_(metrics, executor_),
      context_{clock, metrics, executor_, rpc_metrics_, MakeLogger(program, config.log_level(), config.log_format())} {
  context_.client_names.assign(config.tls().client_names().begin(), config.tls().client_names().end());
}

}  // namespace flair::runtime
