// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/pipeline/pipeline.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// The queue of a config: in JetStream when it names one, otherwise in its store_path. `clock` outlives it. Errors name
// the field.
absl::StatusOr<std::unique_ptr<WorkQueue>> OpenWorkQueue(const config::v1::OrchestratorConfig& config,
                                                         const runtime::Clock& clock);

// The rest of a config, with defaults.
PipelineOptions PipelineOptionsOf(const config::v1::OrchestratorConfig& config, const std::string& build);
JobRunnerOptions RunnerOptionsOf(const config::v1::OrchestratorConfig& config);
int QueuedJobLimit(const config::v1::OrchestratorConfig& config);
std::optional<absl::Duration> KeepEnded(const config::v1::OrchestratorConfig& config);

// Where a config's artifacts are; see OrchestratorConfig.artifact_store.
absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenArtifactStore(const config::v1::OrchestratorConfig& config,
                                                                 const runtime::Clock& clock);

}  // namespace flair::orchestrator
