// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/open_stores.h"

#include <fmt/format.h>

#include "orchestrator/store/artifact_files.h"
#include "orchestrator/store/sqlite_work_queue.h"

namespace flair::orchestrator {

absl::StatusOr<std::unique_ptr<WorkQueue>> OpenWorkQueue(const config::v1::OrchestratorConfig& config,
                                                         const runtime::Clock& clock) {
  return SqliteWorkQueue::Open(config.store_path(), clock);
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenArtifactStore(const config::v1::OrchestratorConfig& config,
                                                                 const runtime::Clock&) {
  const std::string& address = config.artifact_store();
  if (address.empty()) return ArtifactFiles::Open(config.store_path() + "/artifacts");
  if (address.starts_with("folder:")) return ArtifactFiles::Open(address.substr(7));
  return absl::InvalidArgumentError(
      fmt::format("artifact_store: \"{}\" is no store; expected \"folder:PATH\" or \"jetstream:\"", address));
}

}  // namespace flair::orchestrator
