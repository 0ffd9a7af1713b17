// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/renderer_worker_config.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/scene/furnishing.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::renderer {

// Where a renderer takes its furniture from: of its own making, or, with a folder of assets, from there where one fits.
struct FurnishingChoice {
  std::unique_ptr<FurnishingSource> source;
  std::string revision;                     // of the manifest; empty without assets
  std::vector<v1::Diagnostic> diagnostics;  // what of the manifest cannot be used
};

using SceneExporter =
    std::function<absl::StatusOr<v1::ExportSceneResponse>(const v1::ExportSceneRequest&, runtime::CallContext&)>;

// What reads folders of models and writes scenes. A program that does neither goes without it, and need not link it.
struct SceneFiles {
  absl::StatusOr<FurnishingChoice> (*choose_furnishing)(const std::string& asset_folder) = nullptr;
  SceneExporter (*make_exporter)(const FurnishingSource& furnishing, const std::string& build,
                                 int64_t answer_bytes) = nullptr;
};
// Ours, in the library flair_renderer_scene_files.
SceneFiles OurSceneFiles();

// The RendererService, for flair-renderer and for programs that host it themselves. `worker` must outlive it. Loads the
// image library only when the first picture is written. NOT_FOUND and INVALID_ARGUMENT for a folder of assets that
// cannot be used, UNIMPLEMENTED for one without SceneFiles.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeRendererService(const config::v1::RendererWorkerConfig& config,
                                                                   runtime::WorkerContext& worker,
                                                                   const SceneFiles& files);

// In the library flair_renderer_scene_files. NOT_FOUND and INVALID_ARGUMENT name the folder.
absl::StatusOr<FurnishingChoice> ChooseFurnishing(const std::string& asset_folder);

}  // namespace flair::renderer
