// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "renderer_worker/images/image_writer.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {

// Bytes of a pixel in an EXR before compression, which never makes it more.
inline constexpr int kExrPixelBytes = 30;

// The channels of a traced view, see docs/views.md: R, G, B (half), Z (float, metres), N.X, N.Y, N.Z (float, room
// frame), albedo.R, albedo.G, albedo.B (half), instance, class (unsigned). They refer into `view`.
std::vector<ImagePlane> ExrPlanes(const TracedView& view);

}  // namespace flair::renderer
