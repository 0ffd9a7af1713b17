// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/service/export_scene_handler.h"

#include "room/validation/validate.h"

namespace flair::renderer {

absl::StatusOr<v1::ExportSceneResponse> ExportSceneHandler::Handle(const v1::ExportSceneRequest& request,
                                                                   runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  return absl::UnimplementedError("this renderer draws plans (Render); it does not write 3D scenes");
}

}  // namespace flair::renderer
