// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {
namespace {

// Faint lines of wood grain along the longer side of `box`.
void DrawGrain(SymbolPen& pen, const Box& box) {
  const bool wide = box.width() >= box.height();
  const double length = wide ? box.width() : box.height(), across = wide ? box.height() : box.width();
  const int lines = std::clamp(static_cast<int>(across / 0.14), 2, 7);
  for (int i = 1; i < lines; ++i) {
    const double at = across * i / lines;
    const double start = length * (0.06 + 0.05 * ((i * 5) % 3)), end = length * (0.94 - 0.06 * ((i * 7) % 4));
    wide ? pen.Segment({box.x0 + start, box.y0 + at}, {box.x0 + end, box.y0 + at}, Line::kFaint)
         : pen.Segment({box.x0 + at, box.y0 + start}, {box.x0 + at, box.y0 + end}, Line::kFaint);
  }
}

}  // namespace

void DrawTable(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.03);
  const Box top = pen.whole().Grown(-std::min(0.05, 0.08 * pen.smaller()));
  pen.Area(top, Tone::kLight, Line::kFaint, 0.02);
  DrawGrain(pen, top);
}

void DrawRoundTable(SymbolPen& pen) {
  pen.Oval({0, 0}, pen.width() / 2, pen.depth() / 2, Tone::kBody, Line::kOutline);
  pen.Oval({0, 0}, 0.45 * pen.width(), 0.45 * pen.depth(), Tone::kLight, Line::kFaint);
  pen.Oval({0, 0}, 0.12 * pen.width(), 0.12 * pen.depth(), Tone::kNone, Line::kFaint);
}

void DrawCoffeeTable(SymbolPen& pen) {
  const double radius = std::min(0.08, 0.2 * pen.smaller());
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, radius);
  pen.Area(pen.whole().Grown(-0.1 * pen.smaller()), Tone::kLight, Line::kDetail, 0.7 * radius);
}

void DrawNightstand(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.02);
  const double lip = std::min(0.05, 0.12 * pen.depth());
  pen.Area({pen.left(), pen.front() - lip, pen.right(), pen.front()}, Tone::kDark, Line::kDetail);
  pen.Area({-0.05, pen.front() - 0.25 * lip, 0.05, pen.front()}, Tone::kDeep, Line::kNone);
}

void DrawDesk(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.02);
  DrawGrain(pen, pen.whole().Grown(-0.03));
  // A blotter where one sits, drawers below at the left.
  const double half = std::min(0.3, 0.27 * pen.width());
  const double near = pen.front() - 0.06 * pen.depth(), far = near - std::min(0.36, 0.52 * pen.depth());
  pen.Area({-half, far, half, near}, Tone::kBody, Line::kDetail, 0.015);
  const double lip = std::min(0.03, 0.05 * pen.depth());
  pen.Segment({pen.left(), pen.front() - lip}, {-half - 0.03, pen.front() - lip});
  pen.Segment({half + 0.03, pen.front() - lip}, {pen.right(), pen.front() - lip});
}

void DrawVanity(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.03);
  const double lip = std::min(0.04, 0.1 * pen.depth());
  pen.Segment({pen.left(), pen.front() - lip}, {pen.right(), pen.front() - lip});
  pen.Oval({0, pen.back() + 0.16 * pen.depth()}, 0.32 * pen.width(), 0.1 * pen.depth(), Tone::kGlass);
  pen.Circle({0.34 * pen.width(), 0.12 * pen.depth()}, 0.035, Tone::kBody);
  pen.Circle({0.25 * pen.width(), 0.05 * pen.depth()}, 0.022, Tone::kDark);
}

void DrawWorkbench(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.01);
  const int planks = std::clamp(static_cast<int>(pen.depth() / 0.16), 2, 8);
  for (int i = 1; i < planks; ++i) {
    const double y = pen.back() + pen.depth() * i / planks;
    pen.Segment({pen.left(), y}, {pen.right(), y}, Line::kDetail);
  }
  // The vice on the front edge.
  const double vice = std::min(0.2, 0.15 * pen.width()), x = pen.right() - 1.3 * vice;
  pen.Area({x - vice / 2, pen.front() - 0.7 * vice, x + vice / 2, pen.front()}, Tone::kMetal, Line::kDetail);
  pen.Segment({x - vice / 2, pen.front() - 0.3 * vice}, {x + vice / 2, pen.front() - 0.3 * vice});
}

void DrawPoolTable(SymbolPen& pen) {
  const double rail = std::min(0.12, 0.1 * pen.smaller());
  pen.Area(pen.whole(), Tone::kWood, Line::kOutline, 0.05);
  pen.Area(pen.whole().Grown(-rail), Tone::kLeaf, Line::kDetail);
  const bool wide = pen.width() >= pen.depth();
  for (double x : {pen.left() + rail, pen.right() - rail}) {
    for (double y : {pen.back() + rail, pen.front() - rail}) pen.Circle({x, y}, 0.5 * rail, Tone::kDeep);
    if (!wide) pen.Circle({x, 0}, 0.42 * rail, Tone::kDeep);
  }
  if (!wide) return;
  for (double y : {pen.back() + rail, pen.front() - rail}) pen.Circle({0, y}, 0.42 * rail, Tone::kDeep);
}

}  // namespace flair::renderer
