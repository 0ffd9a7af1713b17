// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/orchestrator_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "orchestrator/jetstream/connect_options.h"
#include "orchestrator/jetstream/open.h"
#include "orchestrator/service/make_orchestrator_service.h"
#include "orchestrator/store/artifact_files.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/security/security.h"

namespace flair::orchestrator {
namespace {

const config::v1::TlsConfig* TlsOf(const config::v1::OrchestratorConfig& config) {
  return config.runtime().has_tls() ? &config.runtime().tls() : nullptr;
}

int RunningJobLimit(const config::v1::OrchestratorConfig& config) {
  if (config.running_job_limit() > 0) return config.running_job_limit();
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Reports a queue on other machines that would be spoken to in plain text.
void CheckQueueExposure(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  if (!config.has_queue() || config.runtime().allow_insecure()) return;
  const std::string shown = ShownAddress(config.queue());
  // One encrypted server makes the connections to all of them so.
  if (absl::StrContains(shown, "tls://")) return;
  const std::vector<std::string> servers = absl::StrSplit(shown, ',');
  for (const std::string& server : servers) {
    const std::string host(absl::StripPrefix(server, "nats://"));
    const bool has_port = host.rfind(':') != std::string::npos && !host.ends_with(']');
    if (runtime::IsLocalAddress(has_port ? host : host + ":4222")) continue;
    checker.Report(
        "queue.address",
        fmt::format("\"{}\" is on another machine, and in plain text others can read and change what goes "
                    "there; use tls:// with runtime.tls, or set runtime.allow_insecure: true if only trusted "
                    "machines can reach that network",
                    server));
  }
}

}  // namespace

int QueuedJobLimit(const config::v1::OrchestratorConfig& config) {
  return config.queued_job_limit() > 0 ? config.queued_job_limit() : 1000000;
}

PipelineOptions PipelineOptionsOf(const config::v1::OrchestratorConfig& config, const std::string& build) {
  PipelineOptions options;
  options.build = build;
  if (config.has_stage_deadline_seconds()) options.stage_deadline = absl::Seconds(config.stage_deadline_seconds());
  return options;
}

JobRunnerOptions RunnerOptionsOf(const config::v1::OrchestratorConfig& config) {
  JobRunnerOptions options;
  options.running_job_limit = config.takes_no_jobs() ? 0 : RunningJobLimit(config);
  options.requested_jobs_only = config.requested_jobs_only();
  if (config.attempt_limit() > 0) options.attempt_limit = config.attempt_limit();
  return options;
}

std::optional<absl::Duration> KeepEnded(const config::v1::OrchestratorConfig& config) {
  if (!config.has_keep_ended_seconds()) return std::nullopt;
  return absl::Seconds(config.keep_ended_seconds());
}

absl::StatusOr<std::unique_ptr<WorkQueue>> OpenWorkQueue(const config::v1::OrchestratorConfig& config,
                                                         const runtime::Clock& clock) {
  if (config.has_queue()) return OpenJetStreamQueue(config.queue(), TlsOf(config), clock);
  return SqliteWorkQueue::Open(config.store_path(), clock);
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenArtifactStore(const config::v1::OrchestratorConfig& config,
                                                                 const runtime::Clock& clock) {
  const std::string& address = config.artifact_store();
  if (address.starts_with("folder:")) return ArtifactFiles::Open(address.substr(7));
  if (address.empty() && !config.has_queue()) return LocalArtifacts::Open(config.store_path() + "/artifacts");
  if (!address.empty() && address != "jetstream:") {
    return absl::InvalidArgumentError(
        fmt::format("artifact_store: \"{}\" is no store; expected \"folder:PATH\" or \"jetstream:\"", address));
  }
  if (!config.has_queue()) {
    return absl::InvalidArgumentError(
        "artifact_store: \"jetstream:\" keeps artifacts in the queue's servers; set queue");
  }
  return OpenJetStreamArtifacts(config.queue(), TlsOf(config), clock);
}

void CheckOrchestratorConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker) {
  if (config.store_path().empty() && !config.has_queue()) {
    checker.Report("store_path", "missing; expected a folder, or a queue");
  }
  checker.Range("attempt_limit", config.attempt_limit(), 0, 100);
  checker.Range("running_job_limit", config.running_job_limit(), 0, 256);
  checker.Range("queued_job_limit", config.queued_job_limit(), 0, 10000000);
  if (config.has_stage_deadline_seconds()) {
    checker.Range("stage_deadline_seconds", config.stage_deadline_seconds(), 0.001, 86400);
  }
  if (config.has_keep_ended_seconds()) {
    checker.Range("keep_ended_seconds", config.keep_ended_seconds(), 60, 315360000);
  }
  CheckStageConfig(config, checker);
  CheckQueueExposure(config, checker);
}

}  // namespace flair::orchestrator
