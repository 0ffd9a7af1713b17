// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/contact_sheet/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "renderer_worker/contact_sheet/sheet_band.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
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
  if (absl::Status status = heading.status(); !status.ok()) return status;
  if (grid.heading_px > 0) DrawHeading(heading, grid, title);
  heading.AppendTo(sheet->pixels_);
  return sheet;
}

// Makes place for a tile and writes its text.
absl::Status ContactSheet::Next(const TileText& text) {
  const int column = added_count_ % grid_.column_count;
  if (column == 0) {
    if (absl::Status status = EndBand(); !status.ok()) return status;
    band_ = std::make_unique<SheetBand>(grid_.width_px(), grid_.cell_height_px());
    if (absl::Status status = band_->status(); !status.ok()) return status;
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
    return absl::InternalError(fmt::format("a tile of {} px for a place of {} px",
                                           std::max(picture.width_px, picture.height_px), grid_.tile_px));
  const int column = added_count_ % grid_.column_count;
  if (absl::Status status = Next(text); !status.ok()) return status;
  band_->Put(picture, grid_.gap_px + column * grid_.cell_width_px() + (grid_.tile_px - picture.width_px) / 2,
             (grid_.tile_px - picture.height_px) / 2);
  return absl::OkStatus();
}

absl::Status ContactSheet::AddBroken(const std::string& reason, const TileText& text) {
  const double left = grid_.gap_px + added_count_ % grid_.column_count * grid_.cell_width_px();
  if (absl::Status status = Next(text); !status.ok()) return status;
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
  band_->AppendTo(pixels_);
  band_.reset();
  return absl::OkStatus();
}

absl::StatusOr<Pixels> ContactSheet::Finish() {
  if (absl::Status status = EndBand(); !status.ok()) return status;
  return std::move(pixels_);
}

}  // namespace flair::renderer
