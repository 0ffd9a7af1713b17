// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "absl/status/statusor.h"

namespace flair::renderer {

// Longest side of a contact sheet.
inline constexpr int kLargestSheetPx = 8192;

// Where the tiles of a contact sheet lie, in pixels. A cell is a square picture with its caption and remark below it.
struct SheetGrid {
  int tile_count = 0;
  int column_count = 0;
  int row_count = 0;
  int tile_px = 0;
  int gap_px = 0;        // round every cell and along the edge of the sheet
  int caption_px = 0;    // height of the line of the caption
  int remark_px = 0;     // height of a line of the remark
  int remark_lines = 0;  // 0 for tiles too small to read it
  int heading_px = 0;    // height of the heading, 0 without one

  int cell_width_px() const { return tile_px + gap_px; }
  int cell_height_px() const { return tile_px + caption_px + remark_lines * remark_px + gap_px; }
  int width_px() const { return gap_px + column_count * cell_width_px(); }
  int height_px() const { return gap_px + heading_px + row_count * cell_height_px(); }
};

// Lays out `tile_count` (1 to 10000) tiles, about 4 : 3. Without `tile_px` the largest of up to 480 with which no side
// is above kLargestSheetPx. INVALID_ARGUMENT when tiles of `tile_px` do not fit, with the largest that do.
absl::StatusOr<SheetGrid> ArrangeSheet(int tile_count, std::optional<int> tile_px, bool has_heading);

}  // namespace flair::renderer
