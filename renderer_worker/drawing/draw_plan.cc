// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/draw_plan.h"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "renderer_worker/drawing/layers.h"

namespace flair::renderer {
namespace {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
struct DestroyCairo {
  void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};

void DrawFrame(Canvas& canvas, const Sheet& sheet) {
  canvas.Rectangle({0, 0, sheet.size_mm.width, sheet.size_mm.height});
  canvas.Fill(Hex(0xFFFFFF));
  canvas.Rectangle(Box{0, 0, sheet.size_mm.width, sheet.size_mm.height}.Grown(-6));
  canvas.Draw({Hex(0x8A8379), 0.25});
}

std::vector<PlacedLabel> DrawSheet(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  DrawFrame(canvas, sheet);
  canvas.Rectangle(sheet.plan_mm.Grown(4));
  canvas.Clip();
  DrawFloor(canvas, plan, sheet);
  DrawZones(canvas, plan, sheet);
  DrawFurniture(canvas, plan, sheet);
  DrawWalls(canvas, plan, sheet);
  DrawOpenings(canvas, plan, sheet);
  DrawSockets(canvas, plan, sheet);
  DrawMounted(canvas, plan, sheet);
  DrawDimensions(canvas, plan, sheet);
  std::vector<PlacedLabel> labels = DrawLabels(canvas, plan, sheet);
  canvas.Unclip();
  DrawSidePanel(canvas, plan, sheet);
  return labels;
}

Pixels ReadPixels(cairo_surface_t* surface) {
  cairo_surface_flush(surface);
  Pixels pixels{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  pixels.rgb.reserve(static_cast<size_t>(pixels.width_px) * pixels.height_px * 3);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < pixels.height_px; ++y) {
    const auto* row = reinterpret_cast<const uint32_t*>(data + static_cast<ptrdiff_t>(y) * stride);
    for (int x = 0; x < pixels.width_px; ++x) {
      for (int shift : {16, 8, 0}) pixels.rgb.push_back(static_cast<uint8_t>(row[x] >> shift));
    }
  }
  return pixels;
}

}  // namespace

absl::StatusOr<DrawnPlan> DrawPlan(const v1::SolvedLayout& layout, const v1::RenderOptions& options) {
  const int size_px = options.has_size_px() ? options.size_px() : kDefaultSizePx;
  if (size_px < 256 || size_px > 8192) {
    return absl::InvalidArgumentError(fmt::format("options.size_px: {}; must be in [256, 8192]", size_px));
  }
  absl::StatusOr<Plan> plan = ReadPlan(layout);
  if (!plan.ok()) return plan.status();
  const Sheet sheet = ChooseSheet(*plan);
  const double px_per_mm = size_px / std::max(sheet.size_mm.width, sheet.size_mm.height);
  const int width = static_cast<int>(std::lround(sheet.size_mm.width * px_per_mm));
  const int height = static_cast<int>(std::lround(sheet.size_mm.height * px_per_mm));
  const std::unique_ptr<cairo_surface_t, DestroySurface> surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  const std::unique_ptr<cairo_t, DestroyCairo> cairo(cairo_create(surface.get()));
  if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS) {
    return absl::ResourceExhaustedError(fmt::format("no memory for a picture of {} x {} pixels", width, height));
  }
  cairo_scale(cairo.get(), px_per_mm, px_per_mm);
  Canvas canvas(cairo.get());
  DrawnPlan drawn;
  drawn.labels = DrawSheet(canvas, *plan, sheet);
  if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS) {
    return absl::InternalError(fmt::format("drawing failed: {}", cairo_status_to_string(cairo_status(cairo.get()))));
  }
  drawn.pixels = ReadPixels(surface.get());
  drawn.title = plan->title;
  drawn.scale = sheet.scale;
  return drawn;
}

}  // namespace flair::renderer
