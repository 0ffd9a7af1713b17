// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/clearances.h"
#include "renderer_worker/drawing/dimension_layout.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/text.h"

namespace flair::renderer {
namespace {

const Rgb kDimensionInk = Hex(0x4A4641);

// Texts read from below or from the right, whatever way the wall runs.
double ReadingAngle(Point direction) {
  double angle = std::atan2(-direction.y, direction.x);
  if (angle > std::numbers::pi / 2 + 1e-6) angle -= std::numbers::pi;
  if (angle <= -std::numbers::pi / 2 + 1e-6) angle += std::numbers::pi;
  return angle;
}

void DrawString(Canvas& canvas, const DimensionString& string) {
  const Point overshoot = string.direction * 1.4;
  canvas.Line(string.ticks_mm.front() - overshoot, string.ticks_mm.back() + overshoot);
  canvas.Draw({kDimensionInk, 0.13});
  const Point slash = (string.direction + string.outward) * 0.85;
  for (Point tick : string.ticks_mm) {
    canvas.Line(tick - string.outward * 3.2, tick + string.outward * 1.6);
    canvas.Draw({kDimensionInk, 0.11, 0.8});
    canvas.Line(tick - slash, tick + slash);
    canvas.Draw({kDimensionInk, 0.35});
  }
  const double angle = ReadingAngle(string.direction);
  // "Above" the line as read, so that stacked lines and texts never touch.
  const Point above{-std::sin(angle), -std::cos(angle)};
  const TextStyle style{.size_mm = 3.3, .colour = kDimensionInk};
  for (size_t i = 0; i + 1 < string.ticks_mm.size(); ++i) {
    Point middle = (string.ticks_mm[i] + string.ticks_mm[i + 1]) * 0.5;
    const double length = PieceMm(string, i);
    TextBlock block{string.texts[i], style};
    double width = Measure(canvas, block).width;
    double height_mm = 2.15;
    if (length < kLeastPieceMm && i == 0) {
      middle = string.ticks_mm.front() - string.direction * (width / 2 + 1.6);
    } else if (length < kLeastPieceMm && i + 1 == string.texts.size()) {
      middle = string.ticks_mm.back() + string.direction * (width / 2 + 1.6);
    } else if (width > length - 1) {
      block.style.size_mm *= 0.8;
      if (0.8 * width > length - 0.4) height_mm += 2.9;  // over its neighbours
    }
    DrawTextAt(canvas, block, middle + above * height_mm, angle);
  }
}

}  // namespace

void DrawDimensions(Canvas& canvas, const Plan& plan, const Sheet& sheet) {
  for (const DimensionString& string : LayOutDimensions(plan, sheet)) DrawString(canvas, string);
  DrawClearances(canvas, plan, sheet);
}

}  // namespace flair::renderer
