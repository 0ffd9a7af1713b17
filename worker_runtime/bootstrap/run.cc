// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/bootstrap/run.h"

#include <fmt/format.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <thread>

#include "worker_runtime/logging/log.h"
#include "worker_runtime/metrics/prometheus_metrics.h"
#include "worker_runtime/status/status_macros.h"

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
  ASSIGN_OR_RETURN(metrics_endpoint_, MetricsEndpoint::Start(config_.metrics_address(), *metrics_));
  return absl::OkStatus();
}

absl::Status Worker::Start() {
  RETURN_IF_ERROR(StartMetrics());
  const std::string listen = config_.listen_address().empty() ? "127.0.0.1:0" : config_.listen_address();
  ASSIGN_OR_RETURN(server_, Server::Start({.program = resources_.program(),
                                           .revision = context().revision,
                                           .build = context().build,
                                           .capabilities = context().capabilities,
                                           .configuration_digest = ConfigurationDigest(context()),
                                           .listen_address = listen,
                                           .max_message_mib = config_.max_message_mib(),
                                           .tls = config_.has_tls() ? std::optional(config_.tls()) : std::nullopt,
                                           .open_calls = context().rpc_metrics.open_calls()},
                                          std::move(services_)));
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

namespace flair::runtime::internal {
namespace {

// Blocks the signals in this thread and in all that it starts later.
sigset_t BlockStopSignals() {
  signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

void WaitForSignal(const sigset_t& signals) {
  int signal_number = 0;
  while (sigwait(&signals, &signal_number) != 0) {
  }
}

std::string Usage(const Program& program, const google::protobuf::Message& config) {
  return fmt::format(
      "{0}: {1}\n\nUsage: {0} CONFIG\n       {0} --help\n\nCONFIG is a text proto of {2} with these "
      "fields:\n{3}\nServes until SIGTERM or SIGINT, then finishes running calls. A second signal ends it at once.\n",
      program.name, program.summary, config.GetDescriptor()->full_name(), DescribeConfig(*config.GetDescriptor()));
}

// From here on a signal asks for a stop; once the stop has begun, another one ends the process at once.
void EndAtOnceOnSignal(const sigset_t& signals) {
  std::thread([signals] {
    WaitForSignal(signals);
    _exit(1);
  }).detach();
}

}  // namespace

int RunProgram(int argc, char** argv, const Program& program, google::protobuf::Message& config,
               const std::function<const config::v1::RuntimeConfig&()>& runtime,
               const std::function<void(ConfigChecker&)>& check, const std::function<absl::Status(Worker&)>& assemble) {
  const std::string argument = argc == 2 ? argv[1] : "";
  if (argument == "--help" || argument == "-h") {
    std::fputs(Usage(program, config).c_str(), stdout);
    return 0;
  }
  if (argument.empty() || argument.starts_with("-")) {
    std::fputs(Usage(program, config).c_str(), stderr);
    return 2;
  }
  if (absl::Status status = ReadConfigFile(argument, config, check); !status.ok()) {
    fmt::print(stderr, "{}: bad config\n{}\n", program.name, std::string(status.message()));
    return 2;
  }
  // Every failure is reported with its reason below; gRPC would print the same once more, for its authors.
  setenv("GRPC_VERBOSITY", "NONE", 0);
  const sigset_t signals = BlockStopSignals();
  Worker worker(program.name, runtime());
  worker.context().build = program.build;
  absl::Status status = assemble(worker);
  if (status.ok()) status = worker.Start();
  if (!status.ok()) {
    fmt::print(stderr, "{}: {}\n", program.name, std::string(status.message()));
    return status.code() == absl::StatusCode::kInvalidArgument ? 2 : 1;
  }
  WaitForSignal(signals);
  EndAtOnceOnSignal(signals);
  worker.Stop();
  return 0;
}

}  // namespace flair::runtime::internal
