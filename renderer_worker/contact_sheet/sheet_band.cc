// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/contact_sheet/sheet_band.h"

#include <cstring>

namespace flair::renderer {

SheetBand::SheetBand(int width_px, int height_px)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width_px, height_px)),
      cairo_(cairo_create(surface_.get())),
      canvas_(std::make_unique<Canvas>(cairo_.get())) {
  cairo_set_source_rgb(cairo_.get(), 1, 1, 1);
  cairo_paint(cairo_.get());
}

absl::Status SheetBand::status() const {
  if (cairo_surface_status(surface_.get()) == CAIRO_STATUS_SUCCESS &&
      cairo_status(cairo_.get()) == CAIRO_STATUS_SUCCESS)
    return absl::OkStatus();
  return absl::ResourceExhaustedError("no memory for the contact sheet; ask for smaller tiles");
}

void SheetBand::Put(const Pixels& picture, int left_px, int top_px) {
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

void SheetBand::AppendTo(Pixels& pixels) const {
  cairo_surface_flush(surface_.get());
  const unsigned char* rows = cairo_image_surface_get_data(surface_.get());
  const int stride = cairo_image_surface_get_stride(surface_.get());
  const int width = cairo_image_surface_get_width(surface_.get());
  const int height = cairo_image_surface_get_height(surface_.get());
  for (int y = 0; y < height; ++y) {
    const unsigned char* from = rows + static_cast<ptrdiff_t>(y) * stride;
    for (int x = 0; x < width; ++x, from += 4) {
      uint32_t pixel = 0;
      std::memcpy(&pixel, from, 4);
      for (const int shift : {16, 8, 0}) pixels.rgb.push_back(static_cast<uint8_t>(pixel >> shift));
    }
  }
  pixels.width_px = width;
  pixels.height_px += height;
}

}  // namespace flair::renderer
