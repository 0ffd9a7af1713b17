// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {

void DrawBath(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kPale, Line::kOutline, 0.04);
  const double rim = std::min(0.09, 0.12 * pen.smaller());
  const Box tub = pen.whole().Grown(-rim);
  pen.Area(tub, Tone::kWater, Line::kDetail, 0.42 * std::min(tub.width(), tub.height()));
  pen.Area(tub.Grown(-0.35 * rim), Tone::kNone, Line::kFaint, 0.4 * std::min(tub.width(), tub.height()));
  // Drain and tap at the left or back end of the longer side.
  const bool along = pen.width() >= pen.depth();
  const Point drain = along ? Point{tub.x0 + 0.14 * tub.width(), 0} : Point{0, tub.y0 + 0.14 * tub.height()};
  const Point tap = along ? Point{pen.left() + 0.5 * rim, 0} : Point{0, pen.back() + 0.5 * rim};
  pen.Circle(drain, 0.03, Tone::kMetal);
  pen.Circle(tap, 0.03, Tone::kMetal);
  pen.Segment(tap, along ? Point{tap.x + 1.1 * rim, 0} : Point{0, tap.y + 1.1 * rim}, Line::kOutline);
}

void DrawShower(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kPale, Line::kOutline, 0.02);
  const Box tray = pen.whole().Grown(-std::min(0.05, 0.06 * pen.smaller()));
  pen.Area(tray, Tone::kWater, Line::kDetail, 0.02);
  pen.Segment({tray.x0, tray.y0}, {tray.x1, tray.y1}, Line::kFaint);
  pen.Segment({tray.x1, tray.y0}, {tray.x0, tray.y1}, Line::kFaint);
  pen.Circle({0, 0}, 0.045, Tone::kMetal);
  const Point head{0, tray.y0 + 0.16 * tray.height()};
  pen.Segment({0, pen.back()}, head, Line::kOutline);
  pen.Circle(head, 0.09, Tone::kPale);
  for (Point drop : {Point{0, 0}, Point{0.045, 0}, Point{-0.045, 0}, Point{0, 0.045}, Point{0, -0.045}}) {
    pen.Circle(head + drop, 0.009, Tone::kDeep, Line::kNone);
  }
}

void DrawToilet(SymbolPen& pen) {
  const double tank = std::min(0.19, 0.3 * pen.depth());
  pen.Area({pen.left(), pen.back(), pen.right(), pen.back() + tank}, Tone::kPale, Line::kOutline, 0.03);
  pen.Circle({0, pen.back() + tank / 2}, 0.028, Tone::kBody);
  const double y0 = pen.back() + tank, ry = (pen.front() - y0) / 2, rx = 0.44 * pen.width();
  pen.Area({-0.7 * rx, y0 - 0.01, 0.7 * rx, y0 + 0.6 * ry}, Tone::kPale, Line::kDetail);
  pen.Oval({0, y0 + ry}, rx, ry, Tone::kPale, Line::kOutline);
  pen.Oval({0, y0 + 1.04 * ry}, 0.7 * rx, 0.72 * ry, Tone::kWater, Line::kDetail);
}

void DrawBasin(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kPale, Line::kOutline, 0.06);
  const int bowls = pen.width() >= 1.15 ? 2 : 1;
  for (int i = 0; i < bowls; ++i) {
    const double x = pen.left() + pen.width() * (i + 0.5) / bowls, y = 0.08 * pen.depth();
    pen.Oval({x, y}, std::min(0.27, 0.38 * pen.width() / bowls), 0.33 * pen.depth(), Tone::kWater);
    pen.Circle({x, y}, 0.02, Tone::kDeep, Line::kNone);
    const Point tap{x, pen.back() + 0.1 * pen.depth()};
    pen.Circle(tap, 0.024, Tone::kMetal);
    pen.Segment(tap, {x, tap.y + 0.24 * pen.depth()}, Line::kOutline);
  }
}

}  // namespace flair::renderer
