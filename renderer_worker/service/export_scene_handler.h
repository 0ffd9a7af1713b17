// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/scene/furnishing.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Answers RendererService.ExportScene: binary glTF, or SceneState JSON.
class ExportSceneHandler {
 public:
  // `furnishing` must outlive the handler. `build` is what the program was built from.
  ExportSceneHandler(const FurnishingSource& furnishing, std::string build, int64_t answer_bytes)
      : furnishing_(furnishing), build_(std::move(build)), answer_bytes_(answer_bytes) {}

  absl::StatusOr<v1::ExportSceneResponse> Handle(const v1::ExportSceneRequest& request,
                                                 runtime::CallContext& call) const;

 private:
  const FurnishingSource& furnishing_;
  const std::string build_;
  const int64_t answer_bytes_;
};

}  // namespace flair::renderer
