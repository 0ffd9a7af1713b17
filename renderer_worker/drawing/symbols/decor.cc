// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {

using std::numbers::pi;

void DrawPlant(SymbolPen& pen) {
  const double rx = pen.width() / 2, ry = pen.depth() / 2;
  pen.Oval({0, 0}, 0.5 * rx, 0.5 * ry, Tone::kWood, Line::kOutline);
  const int leaves = 9;
  for (int ring = 0; ring < 2; ++ring) {
    for (int i = 0; i < leaves; ++i) {
      const double angle = 2 * pi * (i + 0.5 * ring) / leaves, reach = ring == 0 ? 1.0 : 0.66,
                   half = ring == 0 ? 0.22 : 0.26;
      const Point tip{reach * rx * std::cos(angle), reach * ry * std::sin(angle)};
      const Point side_1{0.55 * reach * rx * std::cos(angle + half), 0.55 * reach * ry * std::sin(angle + half)};
      const Point side_2{0.55 * reach * rx * std::cos(angle - half), 0.55 * reach * ry * std::sin(angle - half)};
      const Point leaf[] = {{0, 0}, side_1, tip, side_2};
      pen.Shape(leaf, Tone::kLeaf, Line::kFaint);
      pen.Segment({0, 0}, {0.85 * tip.x, 0.85 * tip.y}, Line::kFaint);
    }
  }
  pen.Oval({0, 0}, 0.1 * rx, 0.1 * ry, Tone::kLeaf, Line::kFaint);
}

void DrawLamp(SymbolPen& pen) {
  const double r = pen.smaller() / 2;
  pen.Circle({0, 0}, r, Tone::kPale, Line::kOutline);
  pen.Circle({0, 0}, 0.45 * r, Tone::kLight, Line::kDetail);
  pen.Segment({-r, 0}, {r, 0}, Line::kFaint);
  pen.Segment({0, -r}, {0, r}, Line::kFaint);
}

void DrawScreen(SymbolPen& pen) {
  // The screen is a thin bar that faces the front, on a foot.
  const double bar = std::max(0.05, 0.3 * pen.depth());
  pen.Oval({0, 0}, 0.22 * pen.width(), pen.depth() / 2, Tone::kMetal);
  pen.Area({pen.left(), -0.35 * bar, pen.right(), 0.65 * bar}, Tone::kDeep, Line::kOutline, 0.01);
  pen.Segment({0.95 * pen.left(), 0.45 * bar}, {0.95 * pen.right(), 0.45 * bar}, Line::kFaint);
}

void DrawLaptop(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kMetal, Line::kOutline, 0.015);
  pen.Area({pen.left(), pen.back(), pen.right(), pen.back() + 0.2 * pen.depth()}, Tone::kDeep, Line::kDetail, 0.01);
  pen.Area({0.85 * pen.left(), -0.22 * pen.depth(), 0.85 * pen.right(), 0.16 * pen.depth()}, Tone::kLight,
           Line::kFaint);
  pen.Area({0.26 * pen.left(), 0.22 * pen.depth(), 0.26 * pen.right(), 0.42 * pen.depth()}, Tone::kPale, Line::kFaint);
}

void DrawBooks(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline);
  const Box upper = pen.whole().Grown(-0.1 * pen.smaller());
  pen.Area(upper, Tone::kBody, Line::kDetail);
  pen.Segment({upper.x0 + 0.1 * upper.width(), upper.y0}, {upper.x0 + 0.1 * upper.width(), upper.y1});
}

void DrawVase(SymbolPen& pen) {
  const double rx = pen.width() / 2, ry = pen.depth() / 2;
  pen.Oval({0, 0}, rx, ry, Tone::kBody, Line::kOutline);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * pi * i / 5 + 0.4;
    pen.Oval({0.45 * rx * std::cos(angle), 0.45 * ry * std::sin(angle)}, 0.32 * rx, 0.32 * ry,
             i % 2 == 0 ? Tone::kPale : Tone::kLeaf, Line::kFaint);
  }
}

void DrawTray(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.12 * pen.smaller());
  pen.Area(pen.whole().Grown(-0.1 * pen.smaller()), Tone::kLight, Line::kFaint, 0.08 * pen.smaller());
  pen.Circle({-0.16 * pen.width(), 0.02 * pen.depth()}, 0.16 * pen.smaller(), Tone::kPale);
  pen.Circle({0.2 * pen.width(), -0.06 * pen.depth()}, 0.12 * pen.smaller(), Tone::kPale);
}

void DrawCandles(SymbolPen& pen) {
  const double r = pen.smaller() / 2;
  pen.Circle({0, 0}, r, Tone::kBody, Line::kOutline);
  for (int i = 0; i < 3; ++i) {
    const double angle = pi / 2 + 2 * pi * i / 3;
    const Point at{0.5 * r * std::cos(angle), 0.5 * r * std::sin(angle)};
    pen.Circle(at, 0.3 * r, Tone::kPale);
    pen.Circle(at, 0.11 * r, Tone::kFire, Line::kNone);
  }
}

void DrawOrb(SymbolPen& pen) {
  const double r = pen.smaller() / 2;
  pen.Circle({0, 0}, r, Tone::kDark, Line::kOutline);
  pen.Circle({0, 0}, 0.74 * r, Tone::kGlass);
  pen.Circle({-0.2 * r, 0.24 * r}, 0.2 * r, Tone::kPale, Line::kNone);
}

}  // namespace flair::renderer
