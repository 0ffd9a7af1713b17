// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "orchestrator/workers/stage_channels.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/config/config_reader.h"
#include "worker_runtime/grpc/server.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::orchestrator {

// OrchestratorService with what it runs on: the store in config.store_path, the job runner, the streams. Jobs that wait
// in the store, also those that a crashed process left, begin at once (unless config.requested_jobs_only). Destroying
// it interrupts running jobs, which go on when the store is opened again.
class OrchestratorService : public runtime::Service {
 public:
  // Ends the streams and interrupts the jobs; call before the server drains.
  virtual void Stop() = 0;
  // Services to serve beside it: calls of its workers, see stage_passage.h. They need it; it must be destroyed last.
  virtual std::vector<runtime::NamedService> Passages() = 0;

 protected:
  using Service::Service;
};

// config.stages is not read: the channels say where the stages are. `context` and the channels' servers outlive the
// service.
absl::StatusOr<std::unique_ptr<OrchestratorService>> MakeOrchestratorService(
    const config::v1::OrchestratorConfig& config, runtime::WorkerContext& context, const StageChannels& channels);

// Reports bad fields of a config file, for Run().
void CheckOrchestratorConfig(const config::v1::OrchestratorConfig& config, runtime::ConfigChecker& checker);

}  // namespace flair::orchestrator
