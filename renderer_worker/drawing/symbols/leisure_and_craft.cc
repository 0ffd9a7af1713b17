// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/symbol.h"

namespace flair::renderer {
namespace {

using std::numbers::pi;

// A keyboard seen from above: white keys towards y1, black keys in twos and threes from y0.
void DrawKeys(SymbolPen& pen, double x0, double x1, double y0, double y1) {
  pen.Area({x0, y0, x1, y1}, Tone::kPale, Line::kDetail);
  const int keys = std::clamp(static_cast<int>((x1 - x0) / 0.047), 7, 52);
  for (int i = 1; i < keys; ++i) {
    const double x = x0 + (x1 - x0) * i / keys;
    pen.Segment({x, y0}, {x, y1}, Line::kFaint);
    if (i % 7 == 3 || i % 7 == 0) continue;
    const double half = 0.28 * (x1 - x0) / keys;
    pen.Area({x - half, y0, x + half, y0 + 0.58 * (y1 - y0)}, Tone::kDeep, Line::kNone);
  }
}

void DrawUprightPiano(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.01);
  const double key_back = pen.back() + 0.52 * pen.depth();
  pen.Area({pen.left(), pen.back(), pen.right(), pen.back() + 0.46 * pen.depth()}, Tone::kDark, Line::kDetail);
  pen.Segment({0.5 * pen.left(), pen.back() + 0.4 * pen.depth()}, {0.5 * pen.right(), pen.back() + 0.4 * pen.depth()});
  DrawKeys(pen, 0.9 * pen.left(), 0.9 * pen.right(), key_back, pen.front() - 0.08 * pen.depth());
}

void DrawGrandPiano(SymbolPen& pen) {
  // Keys at the front, the long bass side on the right, the curved rim on the left, as seen by somebody behind it.
  const double y_key = pen.front() - std::min(0.3, 0.2 * pen.depth());
  const double w = pen.width(), d = pen.depth(), tail = pen.right() - 0.42 * w;
  const Point rim[] = {{pen.right(), y_key},
                       {pen.right(), pen.back() + 0.05 * d},
                       {pen.right() - 0.08 * w, pen.back()},
                       {tail, pen.back() + 0.02 * d},
                       {tail - 0.12 * w, pen.back() + 0.12 * d},
                       {tail - 0.17 * w, pen.back() + 0.3 * d},
                       {tail - 0.28 * w, pen.back() + 0.44 * d},
                       {pen.left() + 0.08 * w, pen.back() + 0.55 * d},
                       {pen.left(), pen.back() + 0.68 * d},
                       {pen.left(), y_key}};
  pen.Shape(rim, Tone::kBody);
  pen.Area({pen.left(), y_key, pen.right(), pen.front()}, Tone::kDark, Line::kOutline, 0.02);
  DrawKeys(pen, 0.9 * pen.left(), 0.9 * pen.right(), y_key + 0.2 * (pen.front() - y_key), pen.front() - 0.02);
  pen.Segment({0.55 * pen.left(), y_key - 0.07}, {0.55 * pen.right(), y_key - 0.07});
  for (int i = 0; i < 6; ++i) {
    const double x = pen.right() - 0.06 * w - 0.06 * w * i;
    pen.Segment({x, pen.back() + 0.12 * d}, {x - 0.1 * w, y_key - 0.14}, Line::kFaint);
  }
}

void DrawKeyboard(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kDark, Line::kOutline, 0.02);
  DrawKeys(pen, 0.94 * pen.left(), 0.94 * pen.right(), 0.1 * pen.back(), 0.85 * pen.front());
}

void DrawDrums(SymbolPen& pen) {
  const double r = pen.smaller() / 2;
  const auto drum = [&](double x, double y, double radius, Tone tone) {
    pen.Circle({x * pen.width(), y * pen.depth()}, radius * r, tone, Line::kOutline);
    pen.Circle({x * pen.width(), y * pen.depth()}, 0.82 * radius * r, Tone::kPale, Line::kFaint);
  };
  pen.Area({-0.36 * r, 0.02 * pen.depth(), 0.36 * r, 0.46 * pen.depth()}, Tone::kBody, Line::kOutline, 0.05);
  drum(-0.16, 0.0, 0.3, Tone::kBody);
  drum(0.16, 0.0, 0.3, Tone::kBody);
  drum(-0.27, -0.2, 0.34, Tone::kLight);
  drum(0.3, -0.18, 0.4, Tone::kBody);
  for (double side : {-1.0, 1.0}) {
    pen.Circle({0.33 * side * pen.width(), 0.3 * pen.depth()}, 0.32 * r, Tone::kFire);
    pen.Circle({0.33 * side * pen.width(), 0.3 * pen.depth()}, 0.05 * r, Tone::kDeep, Line::kNone);
  }
  pen.Circle({0, -0.36 * pen.depth()}, 0.24 * r, Tone::kDark, Line::kOutline);
}

void DrawGuitar(SymbolPen& pen) {
  const double w = pen.width() / 2, d = pen.depth();
  pen.Area({-0.12 * w, pen.back(), 0.12 * w, pen.front() - 0.2 * d}, Tone::kDark, Line::kDetail);
  pen.Oval({0, pen.front() - 0.17 * d}, w, 0.17 * d, Tone::kBody, Line::kOutline);
  pen.Oval({0, pen.front() - 0.36 * d}, 0.78 * w, 0.12 * d, Tone::kBody, Line::kOutline);
  pen.Oval({0, pen.front() - 0.26 * d}, 0.6 * w, 0.1 * d, Tone::kBody, Line::kNone);
  pen.Circle({0, pen.front() - 0.3 * d}, 0.26 * w, Tone::kDeep);
}

void DrawMusicStand(SymbolPen& pen) {
  for (Point foot : {Point{0, 0.45}, Point{-0.4, -0.35}, Point{0.4, -0.35}}) {
    pen.Segment({0, 0}, {foot.x * pen.width(), foot.y * pen.depth()}, Line::kOutline);
  }
  pen.Area({pen.left(), -0.16 * pen.depth(), pen.right(), 0.16 * pen.depth()}, Tone::kPale, Line::kOutline);
  for (int i = -1; i <= 1; ++i)
    pen.Segment({0.9 * pen.left(), 0.08 * i * pen.depth()}, {0.9 * pen.right(), 0.08 * i * pen.depth()}, Line::kFaint);
}

void DrawSpeaker(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kDark, Line::kOutline, 0.02);
  pen.Area({pen.left(), pen.front() - 0.16 * pen.depth(), pen.right(), pen.front()}, Tone::kDeep, Line::kDetail);
  pen.Circle({0, -0.06 * pen.depth()}, 0.2 * pen.smaller(), Tone::kLight);
}

void DrawTreadmill(SymbolPen& pen) {
  // One stands on the belt and looks to the console, which is at the back when its back is to the wall.
  const double rail = 0.13 * pen.width(), console = std::min(0.28, 0.17 * pen.depth());
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.04);
  const Box belt{pen.left() + rail, pen.back() + console, pen.right() - rail, pen.front() - 0.04};
  pen.Area(belt, Tone::kDeep, Line::kDetail);
  for (int i = 1; i < 10; ++i) {
    const double y = belt.y0 + belt.height() * i / 10;
    pen.Segment({belt.x0, y}, {belt.x1, y}, Line::kFaint);
  }
  pen.Area({pen.left(), pen.back() + 0.3 * console, pen.right(), pen.back() + console}, Tone::kDark, Line::kDetail,
           0.03);
  pen.Area({0.45 * pen.left(), pen.back() + 0.42 * console, 0.45 * pen.right(), pen.back() + 0.84 * console},
           Tone::kGlass, Line::kDetail);
  for (double x : {pen.left() + 0.35 * rail, pen.right() - 0.35 * rail}) {
    pen.Segment({x, pen.back() + console}, {x, pen.back() + 0.5 * pen.depth()}, Line::kOutline);
  }
}

void DrawExerciseBike(SymbolPen& pen) {
  const double w = pen.width(), d = pen.depth();
  for (double y : {pen.back() + 0.05 * d, pen.front() - 0.05 * d}) {
    pen.Area({0.85 * pen.left(), y - 0.035 * d, 0.85 * pen.right(), y + 0.035 * d}, Tone::kDark, Line::kDetail, 0.02);
  }
  pen.Area({-0.07 * w, pen.back() + 0.05 * d, 0.07 * w, pen.front() - 0.05 * d}, Tone::kBody, Line::kOutline, 0.02);
  pen.Oval({0, pen.back() + 0.3 * d}, 0.16 * w, 0.24 * d, Tone::kLight, Line::kOutline);
  pen.Segment({pen.left(), pen.back() + 0.32 * d}, {pen.right(), pen.back() + 0.32 * d}, Line::kOutline);
  pen.Oval({0, pen.front() - 0.24 * d}, 0.24 * w, 0.13 * d, Tone::kDeep, Line::kOutline);
  pen.Area({0.75 * pen.left(), -0.02 * d, 0.2 * pen.left(), 0.06 * d}, Tone::kDark, Line::kDetail);
  pen.Area({0.2 * pen.right(), -0.1 * d, 0.75 * pen.right(), -0.02 * d}, Tone::kDark, Line::kDetail);
}

void DrawWeightBench(SymbolPen& pen) {
  const double w = pen.width(), d = pen.depth();
  pen.Area({-0.16 * w, pen.back() + 0.16 * d, 0.16 * w, pen.front()}, Tone::kLight, Line::kOutline, 0.05);
  pen.Segment({-0.16 * w, pen.back() + 0.55 * d}, {0.16 * w, pen.back() + 0.55 * d});
  for (double side : {-0.24 * w, 0.24 * w}) {
    pen.Area({side - 0.03 * w, pen.back(), side + 0.03 * w, pen.back() + 0.3 * d}, Tone::kDark, Line::kDetail);
  }
  const double y = pen.back() + 0.17 * d;
  pen.Area({pen.left(), y - 0.015, pen.right(), y + 0.015}, Tone::kMetal, Line::kDetail);
  for (double side : {-1.0, 1.0}) {
    pen.Area({side * 0.38 * w, y - 0.15 * d, side * 0.42 * w, y + 0.15 * d}, Tone::kDeep, Line::kDetail);
    pen.Area({side * 0.44 * w, y - 0.11 * d, side * 0.47 * w, y + 0.11 * d}, Tone::kDeep, Line::kDetail);
  }
}

// Dumbbells in a rack, side by side.
void DrawWeights(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.02);
  const int count = std::clamp(static_cast<int>(pen.width() / 0.17), 2, 12);
  for (int i = 0; i < count; ++i) {
    const double x = pen.left() + pen.width() * (i + 0.5) / count, half = 0.32 * pen.width() / count;
    pen.Segment({x, 0.6 * pen.back()}, {x, 0.6 * pen.front()}, Line::kOutline);
    for (double side : {-1.0, 1.0}) {
      pen.Area({x - half, side * 0.36 * pen.depth(), x + half, side * 0.16 * pen.depth()}, Tone::kDeep, Line::kDetail,
               0.02);
    }
  }
}

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

}  // namespace

std::span<const Symbol> LeisureAndCraftSymbols() {
  static constexpr Symbol kSymbols[] = {{"upright_piano", DrawUprightPiano},
                                        {"grand_piano", DrawGrandPiano},
                                        {"keyboard", DrawKeyboard},
                                        {"drums", DrawDrums},
                                        {"guitar", DrawGuitar},
                                        {"music_stand", DrawMusicStand},
                                        {"speaker", DrawSpeaker},
                                        {"treadmill", DrawTreadmill},
                                        {"exercise_bike", DrawExerciseBike},
                                        {"weight_bench", DrawWeightBench},
                                        {"weights", DrawWeights},
                                        {"easel", DrawEasel},
                                        {"sewing_machine", DrawSewingMachine},
                                        {"mannequin", DrawMannequin},
                                        {"ironing_board", DrawIroningBoard},
                                        {"statue", DrawStatue},
                                        {"telescope", DrawTelescope},
                                        {"globe", DrawGlobe},
                                        {"tent", DrawTent},
                                        {"toy", DrawToy}};
  return kSymbols;
}

}  // namespace flair::renderer
