// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "renderer_worker/drawing/draw_plan.h"

namespace flair::renderer {

// Largest side of a picture that is read.
inline constexpr int kLargestReadSidePx = 8192;

// Reads a PNG, JPEG or TIFF file that anybody may have written, told apart by its first bytes. The picture is shrunk
// (each pixel the mean of those it covers), never enlarged, to fit the box while its rows are read, so that memory
// stays bounded. What is transparent comes over white. INVALID_ARGUMENT says what is wrong with the bytes: no such
// format, too large (before any pixel is decoded), truncated. UNAVAILABLE when the module cannot be loaded.
// Thread-safe.
absl::StatusOr<Pixels> ReadImage(std::string_view bytes, int box_width_px, int box_height_px);

}  // namespace flair::renderer
