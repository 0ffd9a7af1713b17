// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>

#include "absl/status/statusor.h"
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::renderer {

// The RendererService, for flair-renderer and for programs that host it themselves. `worker` must outlive it. Loads the
// image library only when the first picture is written. NOT_FOUND and INVALID_ARGUMENT for a folder of assets that
// cannot be used.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeRendererService(const config::v1::RendererWorkerConfig& config,
                                                                   runtime::WorkerContext& worker);

}  // namespace flair::renderer
