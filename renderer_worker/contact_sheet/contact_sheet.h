// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "renderer_worker/drawing/draw_plan.h"

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

class SheetBand;

// What is written below a tile.
struct TileText {
  std::string caption;
  std::string remark;
};

// A sheet that is drawn row of tiles by row of tiles: beside its finished pixels it holds one row. The same tiles give
// the same pixels. Not thread-safe.
class ContactSheet {
 public:
  // RESOURCE_EXHAUSTED when there is no memory for it.
  static absl::StatusOr<std::unique_ptr<ContactSheet>> Make(const SheetGrid& grid, const std::string& title);
  ~ContactSheet();

  // The next tile, left to right, top to bottom: a picture of at most tile_px a side, in the middle of its place.
  absl::Status Add(const Pixels& picture, const TileText& text);
  // The next tile, which could not be drawn, and why.
  absl::Status AddBroken(const std::string& reason, const TileText& text);

  int added_count() const { return added_count_; }

  // The sheet; nothing may be added after.
  absl::StatusOr<Pixels> Finish();

 private:
  explicit ContactSheet(const SheetGrid& grid);
  absl::Status Next(const TileText& text);
  absl::Status EndBand();

  const SheetGrid grid_;
  int added_count_ = 0;
  std::unique_ptr<SheetBand> band_;
  Pixels pixels_;
};

}  // namespace flair::renderer
