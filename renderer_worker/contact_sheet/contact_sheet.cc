// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/contact_sheet/contact_sheet.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <utility>

#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/sheet.h"
#include "renderer_worker/drawing/text.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

// A strip of white pixels to draw on, one unit a pixel, origin at its upper left corner.
class SheetBand {
 public:
  SheetBand(int width_px, int height_px)
      : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)),
        cairo_(cairo_create(surface_.get())),
        canvas_(std::make_unique<Canvas>(cairo_.get())) {
    cairo_set_source_rgb(cairo_.get(), 1, 1, 1);
    cairo_paint(cairo_.get());
  }

  // RESOURCE_EXHAUSTED when something of it could not be had.
  absl::Status status() const {
    if (cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS &&
        cairo_status(cairo_.get()) == CAIRO_STATUS_SUCCESS)
      return absl::OkStatus();
    return absl::ResourceExhaustedError("no memory for the contact sheet; ask for smaller tiles");
  }
  Canvas& canvas() { return *canvas_; }
  // With the upper left corner there.
  void Put(const Pixels& picture, int left_px, int top_px) {
    cairo_surface_flush(surface_.get());
    unsigned char* rows = cairo_image_surface_get_data(surface_.get());
    if (rows == nullptr) return;
    const int stride = cairo_image_surface_get_stride(surface_.get());
    for (int y = 0; y < picture.height_px; ++y) {
      const uint8_t* from = picture.rgb.data() + static_cast<size_t>(y) * static_cast<size_t>(picture.width_px) * 3;
      unsigned char* to = rows + static_cast<ptrdiff_t>(top_px + y) * stride + static_cast<ptrdiff_t>(left_px) * 4;
      for (int x = 0; x < picture.width_px; ++x, from += 3, to += 4) {
        const uint32_t pixel = uint32_t{from[0]} << 16 | uint32_t{from[1]} << 8 | from[2];
        std::memcpy(to, &pixel, 4);
      }
    }
    cairo_surface_mark_dirty(surface_.get());
  }
  cairo_surface_t* surface() const { return surface_.get(); }

 private:
  SurfacePtr surface_;
  CairoPtr cairo_;
  std::unique_ptr<Canvas> canvas_;
};

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
    return InvalidArgument("options.tile_px: {} tiles of {} px make a sheet larger than {} px; at most {}", tile_count,
                           *tile_px, kLargestSheetPx, largest);
  }
  return InvalidArgument("options.tile_count: {} tiles do not fit a sheet of {} x {} px", tile_count, kLargestSheetPx,
                         kLargestSheetPx);
}

namespace {

const Rgb kInk = Hex(0x2B2926);
const Rgb kQuietInk = Hex(0x77726B);
const Rgb kBrokenInk = Hex(0x9A3B2E);
const Rgb kBrokenGround = Hex(0xF6F1EE);

void DrawHeading(SheetBand& band, const SheetGrid& grid, const std::string& title) {
  const double size = grid.heading_px * 0.42;
  const double count_width = size * 9;
  const double width = grid.width_px() - 2.0 * grid.gap_px;
  DrawText(band.canvas(),
           {.text = title,
            .style = {.size_mm = size, .colour = kInk, .bold = true},
            .max_width_mm = std::max(width / 2, width - count_width)},
           {static_cast<double>(grid.gap_px), static_cast<double>(grid.gap_px)});
  if (width < 3 * count_width) return;
  DrawText(band.canvas(),
           {.text = fmt::format("{} picture{}", grid.tile_count, grid.tile_count == 1 ? "" : "s"),
            .style = {.size_mm = size * 0.6, .colour = kQuietInk},
            .max_width_mm = count_width,
            .align = Align::kRight},
           {grid.gap_px + width - count_width, grid.gap_px + size * 0.4});
}

}  // namespace

ContactSheet::ContactSheet(const SheetGrid& grid) : grid_(grid) {}
ContactSheet::~ContactSheet() = default;

absl::StatusOr<std::unique_ptr<ContactSheet>> ContactSheet::Make(const SheetGrid& grid, const std::string& title) {
  std::unique_ptr<ContactSheet> sheet(new ContactSheet(grid));
  try {
    sheet->pixels_.rgb.reserve(size_t{3} * static_cast<size_t>(grid.width_px()) *
                               static_cast<size_t>(grid.height_px()));
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("no memory for the contact sheet; ask for smaller tiles");
  }
  SheetBand heading(grid.width_px(), grid.gap_px + grid.heading_px);
  RETURN_IF_ERROR(heading.status());
  if (grid.heading_px > 0) DrawHeading(heading, grid, title);
  AppendPixels(heading.surface(), sheet->pixels_);
  return sheet;
}

// Makes place for a tile and writes its text.
absl::Status ContactSheet::Next(const TileText& text) {
  const int column = added_count_ % grid_.column_count;
  if (column == 0) {
    RETURN_IF_ERROR(EndBand());
    band_ = std::make_unique<SheetBand>(grid_.width_px(), grid_.cell_height_px());
    RETURN_IF_ERROR(band_->status());
  }
  ++added_count_;
  const double left = grid_.gap_px + column * grid_.cell_width_px();
  const double width = grid_.tile_px;
  DrawText(band_->canvas(),
           {.text = text.caption,
            .style = {.size_mm = grid_.caption_px * 0.62, .colour = kInk, .bold = true},
            .max_width_mm = width},
           {left, grid_.tile_px + grid_.caption_px * 0.14});
  if (grid_.remark_lines > 0 && !text.remark.empty()) {
    DrawText(band_->canvas(),
             {.text = text.remark,
              .style = {.size_mm = grid_.remark_px * 0.68, .colour = kQuietInk},
              .max_width_mm = width,
              .max_lines = grid_.remark_lines},
             {left, static_cast<double>(grid_.tile_px + grid_.caption_px)});
  }
  return band_->status();
}

absl::Status ContactSheet::Add(const Pixels& picture, const TileText& text) {
  if (picture.width_px > grid_.tile_px || picture.height_px > grid_.tile_px)
    return Internal("a tile of {} px for a place of {} px", std::max(picture.width_px, picture.height_px),
                    grid_.tile_px);
  const int column = added_count_ % grid_.column_count;
  RETURN_IF_ERROR(Next(text));
  band_->Put(picture, grid_.gap_px + column * grid_.cell_width_px() + (grid_.tile_px - picture.width_px) / 2,
             (grid_.tile_px - picture.height_px) / 2);
  return absl::OkStatus();
}

absl::Status ContactSheet::AddBroken(const std::string& reason, const TileText& text) {
  const double left = grid_.gap_px + added_count_ % grid_.column_count * grid_.cell_width_px();
  RETURN_IF_ERROR(Next(text));
  const double width = grid_.tile_px;
  Canvas& canvas = band_->canvas();
  canvas.Rectangle({left + 1, 1, left + width - 1, width - 1}, width * 0.03);
  canvas.Fill(kBrokenGround, 1, true);
  canvas.Draw({.colour = kBrokenInk, .width_mm = 1, .alpha = 0.6, .dash = Dash::kDashed});
  const double size = std::clamp(width * 0.05, 8.0, 18.0);
  TextBlock block{.text = reason,
                  .style = {.size_mm = size, .colour = kBrokenInk},
                  .max_width_mm = width * 0.84,
                  .max_lines = std::max(1, static_cast<int>(width * 0.8 / (1.35 * size))),
                  .align = Align::kCentre};
  const double height = Measure(canvas, block).height;
  DrawText(canvas, block, {left + width * 0.08, std::max(width * 0.06, (width - height) / 2)});
  return band_->status();
}

absl::Status ContactSheet::EndBand() {
  if (band_ == nullptr) return absl::OkStatus();
  AppendPixels(band_->surface(), pixels_);
  band_.reset();
  return absl::OkStatus();
}

absl::StatusOr<Pixels> ContactSheet::Finish() {
  RETURN_IF_ERROR(EndBand());
  return std::move(pixels_);
}

}  // namespace flair::renderer
