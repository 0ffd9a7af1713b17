// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "renderer_worker/scene/furnishing.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::renderer {

// The RendererService, for flair-renderer and for programs that host it themselves. `worker` must outlive it. Loads the
// image library only when the first picture is written. NOT_FOUND and INVALID_ARGUMENT for a folder of assets that
// cannot be used.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeRendererService(const config::v1::RendererWorkerConfig& config,
                                                                   runtime::WorkerContext& worker);

// Where a renderer takes its furniture from: of its own making, or, with a folder of assets, from there where one fits.
struct FurnishingChoice {
  std::unique_ptr<FurnishingSource> source;
  std::string revision;                     // of the manifest; empty without assets
  std::vector<v1::Diagnostic> diagnostics;  // what of the manifest cannot be used
};

// NOT_FOUND and INVALID_ARGUMENT name the folder.
absl::StatusOr<FurnishingChoice> ChooseFurnishing(const std::string& asset_folder);

}  // namespace flair::renderer
