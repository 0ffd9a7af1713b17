// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::orchestrator {

// The queue of a config: in JetStream when it names one, otherwise in its store_path. `clock` outlives it. Errors name
// the field.
absl::StatusOr<std::unique_ptr<WorkQueue>> OpenWorkQueue(const config::v1::OrchestratorConfig& config,
                                                         const runtime::Clock& clock);

// Reports a queue on other machines that would be spoken to in plain text.
void CheckQueueExposure(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker);

// Where a config's artifacts are; see OrchestratorConfig.artifact_store.
absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenArtifactStore(const config::v1::OrchestratorConfig& config,
                                                                 const runtime::Clock& clock);

}  // namespace flair::orchestrator
