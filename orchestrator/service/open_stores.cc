// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/open_stores.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_split.h"
#include "absl/strings/strip.h"
#include "orchestrator/jetstream/connect_options.h"
#include "orchestrator/jetstream/open.h"
#include "orchestrator/store/artifact_files.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "worker_runtime/security/security.h"

namespace flair::orchestrator {
namespace {

const config::v1::TlsConfig* TlsOf(const config::v1::OrchestratorConfig& config) {
  return config.runtime().has_tls() ? &config.runtime().tls() : nullptr;
}

}  // namespace

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
                    "there; use tls:// with runtime.tls, or set runtime.allow_insecure: true if only friends "
                    "reach that network",
                    server));
  }
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

}  // namespace flair::orchestrator
