// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/images/image_writer.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Raise whenever equal requests would give another picture.
inline constexpr char kPlanVersion[] = "3";

// Draws PLAN of a valid request into PNG, JPEG, TIFF, SVG or PDF; the last two without any image library.
absl::StatusOr<v1::RenderResponse> RenderPlan(const v1::RenderRequest& request, ImageWriter& writer,
                                              runtime::CallContext& call);

}  // namespace flair::renderer
