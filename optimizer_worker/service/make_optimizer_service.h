// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/optimizer_worker_config.pb.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::optimizer {

// The OptimizerService, for flair-optimizer and for programs that host it themselves. `worker` must outlive it.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeOptimizerService(const config::v1::OptimizerWorkerConfig& config,
                                                                    runtime::WorkerContext& worker);

}  // namespace flair::optimizer
