// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/addresses.h"
#include "orchestrator/workers/connections.h"
#include "orchestrator/workers/stage_channels.h"
#include "orchestrator/workers/workers_of_stage.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

struct StageWorkersOptions {
  config::v1::StageCallConfig calls;
  Lookup lookup = LookUpHost;
  // Between two lookups of names.
  absl::Duration lookup_interval = absl::Seconds(3);
};

// All workers that an orchestrator calls, and the calls to them: docs/workers.md. One thread keeps the connections, and
// one looks up names where there are any. Thread-safe.
class StageWorkers {
 public:
  // `clock` and the servers behind `channels` outlive it.
  StageWorkers(const StageChannels& channels, StageWorkersOptions options, const runtime::Clock& clock);
  // No call is under way.
  ~StageWorkers();

  // The stages as the pipeline asks them. A worker that cannot be reached is UNAVAILABLE with its stage, address and
  // what to do.
  StageClients& clients() { return *clients_; }

  // Every worker, stage by stage.
  std::vector<v1::WorkerStatus> Status() const;

  // Looks up names now, as somebody may want who knows that workers came or went.
  void LookAgain();

 private:
  std::vector<WorkersOfStage*> All();
  void LookUpNames();

  const StageWorkersOptions options_;
  Connections connections_;
  WorkersOfStage language_;
  WorkersOfStage translator_;
  WorkersOfStage optimizer_;
  WorkersOfStage renderer_;
  std::unique_ptr<StageClients> clients_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  bool look_again_ = false;
  // Only where there are names.
  std::optional<std::thread> lookups_;
};

}  // namespace flair::orchestrator
