// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/contact_sheet/sheet_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flair::renderer {
namespace {

constexpr int kDefaultTilePx = 480;
constexpr int kLeastTilePx = 64;
constexpr int kReadableRemarkTilePx = 110;
constexpr double kSheetAspect = 4.0 / 3;

SheetGrid GridOf(int tile_count, int tile_px, bool has_heading) {
  SheetGrid grid;
  grid.tile_count = tile_count;
  grid.tile_px = tile_px;
  grid.gap_px = std::max(6, tile_px / 16);
  grid.caption_px = std::clamp(static_cast<int>(std::lround(tile_px * 0.085)), 13, 34);
  grid.remark_lines = tile_px < kReadableRemarkTilePx ? 0 : 2;
  grid.remark_px = std::clamp(static_cast<int>(std::lround(tile_px * 0.06)), 11, 24);
  grid.heading_px = has_heading ? std::clamp(tile_px / 5, 28, 84) : 0;
  // As wide for its height as wished.
  const double cells = std::sqrt(tile_count * kSheetAspect * grid.cell_height_px() / grid.cell_width_px());
  const int most = std::max(1, (kLargestSheetPx - grid.gap_px) / grid.cell_width_px());
  grid.column_count = std::clamp(static_cast<int>(std::lround(cells)), 1, std::min(most, tile_count));
  const auto rows = [&] { return (tile_count + grid.column_count - 1) / grid.column_count; };
  grid.row_count = rows();
  // Tall cells may overflow below while there is room to the right.
  while (grid.height_px() > kLargestSheetPx && grid.width_px() + grid.cell_width_px() <= kLargestSheetPx) {
    ++grid.column_count;
    grid.row_count = rows();
  }
  return grid;
}

bool Fits(const SheetGrid& grid) { return grid.width_px() <= kLargestSheetPx && grid.height_px() <= kLargestSheetPx; }

}  // namespace

absl::StatusOr<SheetGrid> ArrangeSheet(int tile_count, std::optional<int> tile_px, bool has_heading) {
  if (tile_px) {
    const SheetGrid grid = GridOf(tile_count, *tile_px, has_heading);
    if (Fits(grid)) return grid;
  }
  int largest = kDefaultTilePx;
  if (tile_px) largest = *tile_px - 1;
  for (; largest >= kLeastTilePx; --largest) {
    const SheetGrid grid = GridOf(tile_count, largest, has_heading);
    if (!Fits(grid)) continue;
    if (!tile_px) return grid;
    return absl::InvalidArgumentError(
        fmt::format("options.tile_px: {} tiles of {} px make a sheet larger than {} px; at most {}", tile_count,
                    *tile_px, kLargestSheetPx, largest));
  }
  return absl::InvalidArgumentError(fmt::format("options.tile_count: {} tiles do not fit a sheet of {} x {} px",
                                                tile_count, kLargestSheetPx, kLargestSheetPx));
}

}  // namespace flair::renderer
