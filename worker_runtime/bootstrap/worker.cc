// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/worker.h"

#include <cstdio>

#include "worker_runtime/logging/log.h"
#include "worker_runtime/metrics/metrics_endpoint.h"
#include "worker_runtime/metrics/process_metrics.h"

namespace flair::runtime {
namespace {

std::unique_ptr<PrometheusMetrics> MakeMetrics(const config::v1::RuntimeConfig& config) {
  return config.metrics_address().empty() ? nullptr : std::make_unique<PrometheusMetrics>();
}

void Say(const char* what, const std::string& address) {
  std::printf("%s %s\n", what, address.c_str());
  std::fflush(stdout);
}

}  // namespace

Worker::Worker(const std::string& program, const config::v1::RuntimeConfig& config)
    : config_(config),
      metrics_(MakeMetrics(config)),
      resources_(program, config, SystemClock(), metrics_ != nullptr ? *metrics_ : NullMetrics()) {}

Worker::~Worker() = default;

absl::Status Worker::StartMetrics() {
  if (metrics_ == nullptr) return absl::OkStatus();
  process_metrics_ = std::make_unique<ProcessMetrics>(*metrics_, resources_.program(), context().build);
  auto endpoint = MetricsEndpoint::Start(config_.metrics_address(), *metrics_);
  if (!endpoint.ok()) return endpoint.status();
  metrics_endpoint_ = *std::move(endpoint);
  return absl::OkStatus();
}

absl::Status Worker::Start() {
  if (absl::Status status = StartMetrics(); !status.ok()) return status;
  const std::string listen = config_.listen_address().empty() ? "127.0.0.1:0" : config_.listen_address();
  auto server = Server::Start({.program = resources_.program(),
                               .revision = context().revision,
                               .build = context().build,
                               .capabilities = context().capabilities,
                               .configuration_digest = ConfigurationDigest(context()),
                               .listen_address = listen,
                               .max_message_mib = config_.max_message_mib(),
                               .tls = config_.has_tls() ? std::optional(config_.tls()) : std::nullopt,
                               .open_calls = context().rpc_metrics.open_calls()},
                              std::move(services_));
  if (!server.ok()) return server.status();
  server_ = *std::move(server);
  Say("listening on", server_->address());
  if (metrics_endpoint_ != nullptr) Say("metrics on", metrics_endpoint_->address());
  Log(*context().logger, spdlog::level::info, "listening",
      {{"address", server_->address()},
       {"metrics_address", metrics_endpoint_ == nullptr ? "" : std::string_view(metrics_endpoint_->address())},
       {"build", context().build}});
  return absl::OkStatus();
}

void Worker::Stop() {
  if (server_ == nullptr) return;
  const double drain_seconds = config_.has_drain_seconds() ? config_.drain_seconds() : 10.0;
  context().logger->info("stopping; running calls have {} s", drain_seconds);
  for (const auto& callback : stop_callbacks_) callback();
  server_->Shutdown(absl::Seconds(drain_seconds));
  server_.reset();
  metrics_endpoint_.reset();
  context().logger->info("stopped");
}

}  // namespace flair::runtime
