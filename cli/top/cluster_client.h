// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <memory>
#include <set>
#include <string>

#include "absl/status/statusor.h"
#include "cli/top/cluster_state.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"

namespace flair::cli {

// Asks an orchestrator how its cluster does.
class ClusterClient {
 public:
  explicit ClusterClient(const std::shared_ptr<grpc::Channel>& channel)
      : stub_(v1::OrchestratorService::NewStub(channel)) {}

  // Waits a few seconds for an answer at most.
  absl::StatusOr<ClusterLook> Look();

 private:
  absl::Status AddBatches(ClusterLook& look);

  const std::unique_ptr<v1::OrchestratorService::StubInterface> stub_;
  // Batches that had ended; asked for again now and then, for those that are retried.
  std::set<std::string> ended_;
  int look_count_ = 0;
};

}  // namespace flair::cli
