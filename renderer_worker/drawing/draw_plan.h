// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/labels.h"

namespace flair::renderer {

// Plans of layouts: one geometry, drawn by the same commands as pixels, SVG and PDF. Pure: the same bytes for the same
// layout and options. Thread-safe. Errors of all: INVALID_ARGUMENT names the field that cannot be drawn,
// RESOURCE_EXHAUSTED when there is no memory for the picture, FAILED_PRECONDITION when no font is installed.

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
  int scale = 0;           // 1:scale
  std::string_view paper;  // "A3" or "A4"
  std::vector<PlacedLabel> labels;
};

inline constexpr int kDefaultSizePx = 1600;
inline constexpr int64_t kMostPixels = 150'000'000;

// The plan on its sheet of paper as pixels: `size_px` along its longer side, or so many that `dpi` holds. `remark`
// stands in small print below the title.
absl::StatusOr<DrawnPlan> DrawPlan(const v1::SolvedLayout& layout, const v1::RenderOptions& options,
                                   const std::string& remark = "");

// Name and value, in order. "Title", "Description", "Software" and "Keywords" go where the format has a place for them,
// all others as "name: value" among the keywords.
using DrawingMetadata = std::vector<std::pair<std::string, std::string>>;

// The same sheet as a file, `options.format` SVG or PDF: its page is exactly the paper, one unit of the SVG is one
// millimetre. Letters are outlines, so that no font is needed to read it. Adds title and scale to the metadata unless
// they are there.
absl::StatusOr<std::string> DrawPlanDocument(const v1::SolvedLayout& layout, const v1::RenderOptions& options,
                                             const DrawingMetadata& metadata, const std::string& remark = "");

// The plan without its sheet, dimensions and labels, as large as the box of pixels allows, on white: a tile of a
// contact sheet. Sides in [16, 4096].
absl::StatusOr<Pixels> DrawPlanTile(const v1::SolvedLayout& layout, int width_px, int height_px);

// The plan as it is on A3, in parts that a screen can move; see the messages.
absl::StatusOr<v1::PlanParts> DrawPlanParts(const v1::DrawPlanPartsRequest& request);

}  // namespace flair::renderer
