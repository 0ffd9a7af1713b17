// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/images/image_writer.h"
#include "renderer_worker/scene/furnishing.h"
#include "renderer_worker/service/render_view.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Answers RendererService.Render: plans are drawn, the other views ray-traced.
class RenderHandler {
 public:
  // `writer` and `furnishing` must outlive the handler.
  RenderHandler(ImageWriter& writer, const FurnishingSource& furnishing, const ViewLimits& limits)
      : writer_(writer), furnishing_(furnishing), limits_(limits) {}

  absl::StatusOr<v1::RenderResponse> Handle(const v1::RenderRequest& request, runtime::CallContext& call) const;

 private:
  ImageWriter& writer_;
  const FurnishingSource& furnishing_;
  const ViewLimits limits_;
};

}  // namespace flair::renderer
