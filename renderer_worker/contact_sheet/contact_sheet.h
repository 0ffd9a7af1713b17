// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "renderer_worker/contact_sheet/sheet_grid.h"
#include "renderer_worker/drawing/draw_plan.h"

namespace flair::renderer {

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
