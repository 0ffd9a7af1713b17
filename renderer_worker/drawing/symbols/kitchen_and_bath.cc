// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "renderer_worker/drawing/symbols/symbol.h"

namespace flair::renderer {
namespace {

void DrawSinkBowl(SymbolPen& pen, const Box& bowl, bool with_tap) {
  pen.Area(bowl, Tone::kMetal, Line::kDetail, 0.06);
  pen.Area(bowl.Grown(-0.025), Tone::kWater, Line::kFaint, 0.05);
  pen.Circle(bowl.centre(), 0.022, Tone::kDeep, Line::kNone);
  if (!with_tap) return;
  const Point tap{bowl.centre().x, bowl.y0 - 0.03};
  pen.Circle(tap, 0.022, Tone::kMetal);
  pen.Segment(tap, {tap.x, tap.y + 0.13}, Line::kOutline);
}

void DrawRings(SymbolPen& pen, const Box& plate) {
  pen.Area(plate, Tone::kDeep, Line::kDetail, 0.02);
  const double dx = plate.width() / 4, dy = plate.height() / 4;
  const double large = 0.8 * std::min(dx, dy), small = 0.62 * std::min(dx, dy);
  const Point c = plate.centre();
  for (Point at : {Point{c.x - dx, c.y - dy}, Point{c.x + dx, c.y + dy}}) pen.Circle(at, large, Tone::kMetal);
  for (Point at : {Point{c.x + dx, c.y - dy}, Point{c.x - dx, c.y + dy}}) pen.Circle(at, small, Tone::kMetal);
  for (double x : {c.x - dx, c.x + dx}) {
    for (double y : {c.y - dy, c.y + dy}) pen.Circle({x, y}, 0.35 * small, Tone::kNone, Line::kFaint);
  }
}

// A run of worktop: a sink with drainer and, when there is room, a hob.
void DrawCounter(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight);
  const double lip = std::min(0.04, 0.08 * pen.depth());
  pen.Segment({pen.left(), pen.front() - lip}, {pen.right(), pen.front() - lip});
  const int fronts = std::clamp(static_cast<int>(std::lround(pen.width() / 0.6)), 1, 12);
  for (int i = 1; i < fronts; ++i) {
    const double x = pen.left() + pen.width() * i / fronts;
    pen.Segment({x, pen.front() - lip}, {x, pen.front()});
  }
  if (pen.width() < 1.2 || pen.depth() < 0.4) return;
  const double half = std::min(0.21, 0.36 * pen.depth());
  const double sink_x = pen.left() + (pen.width() >= 1.9 ? 0.28 : 0.5) * pen.width();
  DrawSinkBowl(pen, {sink_x - 0.24, -half + 0.05, sink_x + 0.2, half - 0.02}, true);
  for (int i = 0; i < 5; ++i) {
    const double x = sink_x + 0.26 + 0.05 * i;
    pen.Segment({x, -half + 0.08}, {x, half - 0.05}, Line::kFaint);
  }
  if (pen.width() < 1.9) return;
  const double hob_x = pen.left() + 0.76 * pen.width();
  DrawRings(pen, {hob_x - 0.28, -half, hob_x + 0.28, half - 0.01});
}

void DrawKitchenSink(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight);
  const double lip = std::min(0.04, 0.08 * pen.depth());
  pen.Segment({pen.left(), pen.front() - lip}, {pen.right(), pen.front() - lip});
  const double y0 = pen.back() + 0.24 * pen.depth(), y1 = pen.front() - 0.16 * pen.depth();
  if (pen.width() < 0.8) {
    DrawSinkBowl(pen, {0.72 * pen.left(), y0, 0.72 * pen.right(), y1}, true);
    return;
  }
  DrawSinkBowl(pen, {0.86 * pen.left(), y0, -0.02, y1}, true);
  for (int i = 1; i < 7; ++i) {
    const double x = 0.04 + (0.84 * pen.right() - 0.04) * i / 7;
    pen.Segment({x, y0}, {x, y1}, Line::kFaint);
  }
}

void DrawHob(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight);
  const double lip = std::min(0.06, 0.1 * pen.depth());
  pen.Area({pen.left(), pen.front() - lip, pen.right(), pen.front()}, Tone::kDark, Line::kDetail);
  for (int i = -2; i <= 2; ++i)
    pen.Circle({0.16 * i * pen.width(), pen.front() - lip / 2}, 0.3 * lip, Tone::kPale, Line::kFaint);
  DrawRings(pen, {0.88 * pen.left(), 0.88 * pen.back(), 0.88 * pen.right(), pen.front() - lip - 0.06 * pen.depth()});
}

void DrawFridge(SymbolPen& pen) {
  const double door = std::min(0.06, 0.1 * pen.depth());
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.02);
  const Box body{pen.left(), pen.back(), pen.right(), pen.front() - door};
  pen.Segment({body.x0, body.y0}, {body.x1, body.y1}, Line::kFaint);
  pen.Segment({body.x1, body.y0}, {body.x0, body.y1}, Line::kFaint);
  pen.Area({pen.left(), pen.front() - door, pen.right(), pen.front()}, Tone::kDark, Line::kDetail, 0.02);
  pen.Area({pen.right() - 0.12, pen.front() - 0.3 * door, pen.right() - 0.04, pen.front()}, Tone::kDeep, Line::kNone);
}

void DrawWasher(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kPale, Line::kOutline, 0.02);
  pen.Circle({0, -0.04 * pen.depth()}, 0.34 * pen.smaller(), Tone::kLight);
  pen.Circle({0, -0.04 * pen.depth()}, 0.24 * pen.smaller(), Tone::kWater);
  const double lip = std::min(0.05, 0.09 * pen.depth());
  pen.Area({pen.left(), pen.front() - lip, pen.right(), pen.front()}, Tone::kDark, Line::kDetail);
}

void DrawDishwasher(SymbolPen& pen) {
  const double lip = std::min(0.05, 0.09 * pen.depth());
  pen.Area(pen.whole(), Tone::kPale);
  pen.Area({pen.left(), pen.front() - lip, pen.right(), pen.front()}, Tone::kDark, Line::kDetail);
  for (int i = 1; i < 6; ++i) {
    const double x = pen.left() + pen.width() * i / 6;
    pen.Segment({x, 0.7 * pen.back()}, {x, 0.6 * pen.front()}, Line::kFaint);
  }
}

void DrawCauldron(SymbolPen& pen) {
  const double rx = pen.width() / 2, ry = pen.depth() / 2;
  for (double side : {-1.0, 1.0}) pen.Oval({0.9 * side * rx, 0}, 0.1 * rx, 0.16 * ry, Tone::kDark, Line::kOutline);
  pen.Oval({0, 0}, 0.92 * rx, ry, Tone::kDeep, Line::kOutline);
  pen.Oval({0, 0}, 0.74 * rx, 0.8 * ry, Tone::kLeaf);
  for (Point at : {Point{-0.25, 0.2}, Point{0.2, 0.3}, Point{0.3, -0.2}, Point{-0.1, -0.35}}) {
    pen.Circle({at.x * rx, at.y * ry}, (0.07 + 0.06 * std::abs(at.x + at.y)) * pen.smaller(), Tone::kPale,
               Line::kFaint);
  }
}

void DrawFireplace(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody);
  const double jamb = 0.17 * pen.width(), y0 = pen.back() + 0.18 * pen.depth();
  const Point opening[] = {{pen.left() + 1.5 * jamb, y0},
                           {pen.right() - 1.5 * jamb, y0},
                           {pen.right() - jamb, pen.front()},
                           {pen.left() + jamb, pen.front()}};
  pen.Shape(opening, Tone::kDeep, Line::kDetail);
  const double r = 0.24 * pen.depth();
  for (int i = -1; i <= 1; ++i)
    pen.Oval({0.13 * i * pen.width(), y0 + 1.5 * r}, 0.07 * pen.width(), r, Tone::kFire, Line::kFaint);
  for (double x : {pen.left(), pen.right()}) pen.Segment({0.8 * x, pen.front()}, {x, 0.2 * pen.front()}, Line::kFaint);
}

void DrawSmallAppliance(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.15 * pen.smaller());
  pen.Area({0.7 * pen.left(), 0.6 * pen.back(), 0.25 * pen.right(), 0.6 * pen.front()}, Tone::kGlass, Line::kDetail,
           0.02);
  pen.Circle({0.65 * pen.right(), 0}, 0.1 * pen.smaller(), Tone::kDark);
}

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

}  // namespace

std::span<const Symbol> KitchenAndBathSymbols() {
  static constexpr Symbol kSymbols[] = {{"counter", DrawCounter},
                                        {"kitchen_sink", DrawKitchenSink},
                                        {"hob", DrawHob},
                                        {"fridge", DrawFridge},
                                        {"washer", DrawWasher},
                                        {"dishwasher", DrawDishwasher},
                                        {"cauldron", DrawCauldron},
                                        {"fireplace", DrawFireplace},
                                        {"small_appliance", DrawSmallAppliance},
                                        {"bath", DrawBath},
                                        {"shower", DrawShower},
                                        {"toilet", DrawToilet},
                                        {"basin", DrawBasin}};
  return kSymbols;
}

}  // namespace flair::renderer
