// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/images/image_writer.h"
#include "renderer_worker/scene/furnishing.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::renderer {

// Raise whenever equal requests would give another picture.
inline constexpr char kViewVersion[] = "3";

inline constexpr int kDefaultViewSizePx = 1024;
inline constexpr int kDefaultSampleCount = 16;

struct ViewLimits {
  int thread_count = 1;
  // Largest answer in bytes: a picture that might not fit is refused before it is traced.
  int64_t answer_bytes = 0;
};

// Ray-traces BIRDSEYE or PERSPECTIVE of a valid request into PNG, JPEG, TIFF or EXR. INVALID_ARGUMENT names size_px
// when the picture cannot fit the answer.
absl::StatusOr<v1::RenderResponse> RenderView(const v1::RenderRequest& request, const FurnishingSource& furnishing,
                                              ImageWriter& writer, const ViewLimits& limits,
                                              runtime::CallContext& call);

}  // namespace flair::renderer
