// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/worker_context.h"

#include <spdlog/sinks/stdout_sinks.h>

#include <algorithm>
#include <thread>

#include "spdlog/pattern_formatter.h"
#include "worker_runtime/files/sha256.h"

namespace flair::runtime {
namespace {

int ThreadLimit(const config::v1::RuntimeConfig& config) {
  if (config.worker_thread_count() > 0) return config.worker_thread_count();
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int QueueLimit(const config::v1::RuntimeConfig& config) { return config.queue_limit() > 0 ? config.queue_limit() : 64; }

spdlog::level::level_enum Level(const std::string& level) {
  if (level == "debug") return spdlog::level::debug;
  if (level == "warning") return spdlog::level::warn;
  if (level == "error") return spdlog::level::err;
  return spdlog::level::info;
}

}  // namespace

std::shared_ptr<spdlog::logger> MakeLogger(const std::string& program, const std::string& level) {
  auto sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  sink->set_formatter(
      std::make_unique<spdlog::pattern_formatter>("%Y-%m-%dT%H:%M:%S.%eZ %l %n %v", spdlog::pattern_time_type::utc));
  auto logger = std::make_shared<spdlog::logger>(program, std::move(sink));
  logger->set_level(Level(level));
  logger->flush_on(spdlog::level::info);
  return logger;
}

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
      context_{clock, metrics, executor_, MakeLogger(program, config.log_level())} {}

}  // namespace flair::runtime
