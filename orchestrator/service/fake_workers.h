// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "orchestrator/workers/stage_channels.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/grpc/in_process_server.h"

namespace flair::orchestrator {

// The four workers of stages for tests behind real gRPC, in this process. `stages` outlives it.
class FakeWorkers {
 public:
  explicit FakeWorkers(StageClients& stages);
  const StageChannels& channels() const { return channels_; }

 private:
  std::vector<std::unique_ptr<runtime::InProcessServer>> servers_;
  StageChannels channels_;
};

}  // namespace flair::orchestrator
