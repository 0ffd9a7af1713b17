// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/open_stores.h"

#include <fmt/format.h>

#include "orchestrator/jetstream/open.h"
#include "orchestrator/store/artifact_files.h"
#include "orchestrator/store/sqlite_work_queue.h"

namespace flair::orchestrator {
namespace {

const config::v1::TlsConfig* TlsOf(const config::v1::OrchestratorConfig& config) {
  return config.runtime().has_tls() ? &config.runtime().tls() : nullptr;
}

}  // namespace

absl::StatusOr<std::unique_ptr<WorkQueue>> OpenWorkQueue(const config::v1::OrchestratorConfig& config,
                                                         const runtime::Clock& clock) {
  if (config.has_queue()) return OpenJetStreamQueue(config.queue(), TlsOf(config), clock);
  return SqliteWorkQueue::Open(config.store_path(), clock);
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenArtifactStore(const config::v1::OrchestratorConfig& config,
                                                                 const runtime::Clock& clock) {
  const std::string& address = config.artifact_store();
  if (address.starts_with("folder:")) return ArtifactFiles::Open(address.substr(7));
  if (address.empty() && !config.has_queue()) return ArtifactFiles::Open(config.store_path() + "/artifacts");
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
