// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/images/image_writer.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Answers RendererService.Render.
class RenderHandler {
 public:
  // `writer` must outlive the handler.
  explicit RenderHandler(ImageWriter& writer) : writer_(writer) {}

  absl::StatusOr<v1::RenderResponse> Handle(const v1::RenderRequest& request, runtime::CallContext& call) const;

 private:
  ImageWriter& writer_;
};

}  // namespace flair::renderer
