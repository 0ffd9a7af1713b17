// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/labels.h"

namespace flair::renderer {

// 8-bit RGB, rows from the top, no padding.
struct Pixels {
  int width_px = 0;
  int height_px = 0;
  std::vector<uint8_t> rgb;
};

// What came of a drawing besides its pixels: for metadata and for tests.
struct DrawnPlan {
  Pixels pixels;
  std::string title;
  int scale = 0;  // 1:scale on A3
  std::vector<PlacedLabel> labels;
};

inline constexpr int kDefaultSizePx = 1600;

// Draws the plan of a layout: pure, and the same bytes for the same layout and options. INVALID_ARGUMENT names the
// field that cannot be drawn; RESOURCE_EXHAUSTED when there is no memory for the picture.
absl::StatusOr<DrawnPlan> DrawPlan(const v1::SolvedLayout& layout, const v1::RenderOptions& options);

}  // namespace flair::renderer
