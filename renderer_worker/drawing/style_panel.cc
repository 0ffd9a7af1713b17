// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/panel.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

double DrawPalette(Canvas& canvas, const Plan& plan, double x, double y, double width) {
  const size_t count = std::min<size_t>(plan.palette.size(), 6);
  const double pitch = width / static_cast<double>(std::max<size_t>(count, 5));
  for (size_t i = 0; i < count; ++i) {
    const Box swatch{x + i * pitch, y, x + (i + 1) * pitch - 1.6, y + 7};
    canvas.Rectangle(swatch, 0.8);
    canvas.Fill(plan.palette[i].second, 1, true);
    canvas.Draw({Hex(0x8A8379), 0.12});
    TextBlock name{plan.palette[i].first, {.size_mm = 2.4, .colour = kPanelSoft}, pitch - 1.0, 2};
    DrawText(canvas, name, {swatch.x0, swatch.y1 + 0.7});
  }
  return y + 15;
}

}  // namespace

double DrawStyle(Canvas& canvas, const Plan& plan, const Box& box, bool words, bool draw) {
  if (plan.style_name.empty() && plan.palette.empty() && plan.style_summary.empty()) return 0;
  double y = box.y0;
  const auto paragraph = [&](const std::string& text, TextStyle style, int lines) {
    if (text.empty()) return;
    const TextBlock block{text, style, box.width(), lines};
    if (draw) DrawText(canvas, block, {box.x0, y});
    y += Measure(canvas, block).height + 1.2;
  };
  if (draw) Heading(canvas, "STYLE", box.x0, y);
  y += 5.2;
  paragraph(Capital(plan.style_name), {.size_mm = 4.2, .colour = kPanelInk, .serif = true}, 1);
  if (words) paragraph(plan.style_summary, {.size_mm = 2.9, .colour = kPanelSoft, .line_spacing = 1.08}, 4);
  std::string finishes;
  if (!plan.floor_material.empty()) finishes += "Floor: " + plan.floor_material;
  if (!plan.wall_material.empty()) finishes += (finishes.empty() ? "" : "   ·   ") + ("Walls: " + plan.wall_material);
  if (words) paragraph(finishes, {.size_mm = 2.9, .colour = kPanelInk}, 2);
  if (!plan.palette.empty()) {
    y += 0.8;
    if (draw) DrawPalette(canvas, plan, box.x0, y, box.width());
    y += 14;
  }
  return y - box.y0;
}

}  // namespace flair::renderer
