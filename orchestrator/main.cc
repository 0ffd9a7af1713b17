// SPDX-License-Identifier: GPL-3.0-or-later
// flair-orchestrator: serves OrchestratorService.
#include "absl/synchronization/mutex.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/open.h"
#include "orchestrator/service/make_orchestrator_service.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/bootstrap/run.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

absl::Status Assemble(const config::v1::OrchestratorConfig& config, runtime::Worker& worker) {
  ASSIGN_OR_RETURN(const StageChannels channels, ConnectStages(config));
  ASSIGN_OR_RETURN(auto service, MakeOrchestratorService(config, worker.context(), channels));
  worker.OnStop([&stopping = *service] { stopping.Stop(); });
  std::vector<runtime::NamedService> passages = service->Passages();
  // Services are destroyed in the order of this list.
  for (runtime::NamedService& passage : passages) worker.Serve(passage.name, std::move(passage.service));
  worker.Serve(v1::OrchestratorService::service_full_name(), std::move(service));
  return absl::OkStatus();
}

}  // namespace
}  // namespace flair::orchestrator

int main(int argc, char** argv) {
  // Debian's absl looks for deadlocks at each lock that gRPC takes, under one lock of its own.
  absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore);
  flair::orchestrator::UseNats({flair::orchestrator::OpenJetStreamQueue, flair::orchestrator::OpenJetStreamArtifacts});
  return flair::runtime::Run<flair::config::v1::OrchestratorConfig>(
      argc, argv,
      {"flair-orchestrator", "Serves flair.v1.OrchestratorService: runs briefs through the stages.",
       flair::runtime::BuildName()},
      flair::orchestrator::Assemble, flair::orchestrator::CheckOrchestratorConfig);
}
