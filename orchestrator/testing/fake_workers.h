// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/stage_channels.h"

namespace flair::orchestrator {

// The four workers of stages for tests behind real gRPC, in this process. `stages` outlives it.
class FakeWorkers {
 public:
  explicit FakeWorkers(StageClients& stages);
  ~FakeWorkers();
  // Without a port.
  const StageChannels& channels() const { return channels_; }
  // Where they listen for other processes.
  const config::v1::StageAddresses& addresses() const { return addresses_; }

 private:
  struct Worker;
  template <typename Service, typename Fake>
  StageChannel Start(const char* program, StageClients& stages, std::string& address);

  std::vector<std::unique_ptr<Worker>> workers_;
  StageChannels channels_;
  config::v1::StageAddresses addresses_;
};

}  // namespace flair::orchestrator
