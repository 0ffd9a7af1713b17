// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {

using std::numbers::pi;

void DrawEasel(SymbolPen& pen) {
  const Point leg_back{0, pen.back()}, left{0.8 * pen.left(), 0.8 * pen.front()},
      right{0.8 * pen.right(), 0.8 * pen.front()};
  pen.Segment(leg_back, left, Line::kOutline);
  pen.Segment(leg_back, right, Line::kOutline);
  pen.Segment(leg_back, {0, 0.4 * pen.front()}, Line::kOutline);
  // The canvas leans on it and faces the painter.
  const double y = 0.22 * pen.depth();
  pen.Area({pen.left(), y, pen.right(), y + 0.08 * pen.depth()}, Tone::kPale, Line::kOutline);
  pen.Area({0.9 * pen.left(), y + 0.08 * pen.depth(), 0.9 * pen.right(), pen.front()}, Tone::kWood, Line::kDetail,
           0.01);
  const Tone dabs[] = {Tone::kFire, Tone::kLeaf, Tone::kWater, Tone::kDeep};
  for (int i = 0; i < 4; ++i) {
    pen.Circle({(0.3 * i - 0.45) * pen.width(), 0.4 * pen.depth()}, 0.05 * pen.smaller(), dabs[i], Line::kFaint);
  }
}

void DrawSewingMachine(SymbolPen& pen) {
  const double w = pen.width(), d = pen.depth();
  pen.Area(pen.whole(), Tone::kPale, Line::kOutline, 0.03);
  pen.Area({0.94 * pen.left(), -0.2 * d, 0.86 * pen.right(), 0.16 * d}, Tone::kBody, Line::kDetail, 0.06);
  pen.Area({0.5 * pen.right(), -0.34 * d, 0.86 * pen.right(), 0.3 * d}, Tone::kBody, Line::kDetail, 0.03);
  pen.Oval({pen.right() - 0.06 * w, 0}, 0.055 * w, 0.16 * d, Tone::kMetal);
  pen.Circle({-0.34 * w, 0.02 * d}, 0.06 * pen.smaller(), Tone::kDeep);
  pen.Circle({0.06 * w, -0.02 * d}, 0.09 * pen.smaller(), Tone::kFire, Line::kFaint);
}

void DrawMannequin(SymbolPen& pen) {
  pen.Oval({0, 0}, pen.width() / 2, 0.3 * pen.depth(), Tone::kBody, Line::kOutline);
  pen.Oval({0, 0.08 * pen.depth()}, 0.32 * pen.width(), 0.4 * pen.depth(), Tone::kLight, Line::kDetail);
  pen.Circle({0, 0}, 0.13 * pen.smaller(), Tone::kPale);
  pen.FrontMark();
}

void DrawIroningBoard(SymbolPen& pen) {
  const bool along = pen.width() >= pen.depth();
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.45 * pen.smaller());
  pen.Area(pen.whole().Grown(-0.12 * pen.smaller()), Tone::kNone, Line::kFaint, 0.38 * pen.smaller());
  const double s = 0.12 * pen.smaller();
  const Point at = along ? Point{0.6 * pen.right(), 0} : Point{0, 0.6 * pen.front()};
  pen.Oval(at, along ? 1.6 * s : s, along ? s : 1.6 * s, Tone::kMetal);
}

void DrawStatue(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.01);
  pen.Area(pen.whole().Grown(-0.1 * pen.smaller()), Tone::kPale, Line::kDetail);
  const double r = 0.34 * pen.smaller();
  pen.Oval({0, 0}, r, 0.55 * r, Tone::kBody);
  pen.Oval({0, 0.1 * r}, 0.38 * r, 0.42 * r, Tone::kLight);
  pen.FrontMark();
}

void DrawTelescope(SymbolPen& pen) {
  for (int i = 0; i < 3; ++i) {
    const double angle = pi / 2 + 2 * pi * i / 3;
    pen.Segment({0, 0}, {0.48 * pen.width() * std::cos(angle), 0.48 * pen.depth() * std::sin(angle)}, Line::kOutline);
  }
  const double half = 0.1 * pen.smaller();
  const Point tube[] = {
      {-0.7 * half, pen.back()}, {0.7 * half, pen.back()}, {1.5 * half, pen.front()}, {-1.5 * half, pen.front()}};
  pen.Shape(tube, Tone::kBody);
  pen.Segment({-half, 0.1 * pen.depth()}, {half, 0.1 * pen.depth()});
}

void DrawGlobe(SymbolPen& pen) {
  const double r = pen.smaller() / 2;
  pen.Circle({0, 0}, r, Tone::kWood, Line::kOutline);
  pen.Circle({0, 0}, 0.8 * r, Tone::kWater);
  pen.Oval({0, 0}, 0.36 * r, 0.8 * r, Tone::kNone, Line::kFaint);
  pen.Segment({-0.8 * r, 0}, {0.8 * r, 0}, Line::kFaint);
  pen.Oval({-0.25 * r, 0.28 * r}, 0.28 * r, 0.2 * r, Tone::kLeaf, Line::kFaint);
  pen.Oval({0.3 * r, -0.25 * r}, 0.2 * r, 0.3 * r, Tone::kLeaf, Line::kFaint);
}

void DrawTent(SymbolPen& pen) {
  const int sides = 6;
  Point rim[sides];
  for (int i = 0; i < sides; ++i) {
    const double angle = pi / 2 + 2 * pi * (i + 0.5) / sides;
    rim[i] = {0.577 * pen.width() * std::cos(angle) * std::cos(pi / 6),
              0.5 * pen.depth() * std::sin(angle) / std::cos(pi / 6)};
    rim[i].x = std::clamp(rim[i].x / std::cos(pi / 6), pen.left(), pen.right());
    rim[i].y = std::clamp(rim[i].y, pen.back(), pen.front());
  }
  pen.Shape(rim, Tone::kLight);
  for (Point corner : rim) pen.Segment({0, 0}, corner);
  const Point door[] = {{0, 0.1 * pen.depth()}, {0.16 * pen.width(), pen.front()}, {-0.16 * pen.width(), pen.front()}};
  pen.Shape(door, Tone::kDeep, Line::kDetail);
}

void DrawToy(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.04);
  const double s = 0.3 * pen.smaller();
  pen.Area({-1.2 * s, -0.2 * s, -0.2 * s, 0.8 * s}, Tone::kFire, Line::kDetail);
  pen.Circle({0.7 * s, 0.3 * s}, 0.5 * s, Tone::kWater);
  const Point wedge[] = {{-0.5 * s, -1.2 * s}, {0.5 * s, -1.2 * s}, {0, -0.35 * s}};
  pen.Shape(wedge, Tone::kLeaf, Line::kDetail);
}

}  // namespace flair::renderer
