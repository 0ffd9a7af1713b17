// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Answers RendererService.ExportScene: this version draws plans only and says so.
class ExportSceneHandler {
 public:
  absl::StatusOr<v1::ExportSceneResponse> Handle(const v1::ExportSceneRequest& request,
                                                 runtime::CallContext& call) const;
};

}  // namespace flair::renderer
