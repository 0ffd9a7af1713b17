// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {

using std::numbers::pi;

void DrawPicture(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline);
  pen.Segment({0.94 * pen.left(), 0.4 * pen.front()}, {0.94 * pen.right(), 0.4 * pen.front()}, Line::kFaint);
}

void DrawMirror(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kGlass, Line::kOutline);
  const int strokes = std::clamp(static_cast<int>(pen.width() / 0.12), 2, 12);
  for (int i = 1; i < strokes; ++i) {
    const double x = pen.left() + pen.width() * i / strokes;
    const double lean = std::min(0.3 * pen.depth(), 0.4 * pen.width() / strokes);
    pen.Segment({x - lean, pen.back()}, {x + lean, pen.front()}, Line::kFaint);
  }
}

void DrawCurtain(SymbolPen& pen) {
  // Gathered to both sides: a wave along the rail.
  pen.Segment({pen.left(), pen.back()}, {pen.right(), pen.back()}, Line::kDetail);
  const int waves = std::clamp(static_cast<int>(pen.width() / 0.1), 4, 60);
  for (int i = 0; i < waves; ++i) {
    const double x0 = pen.left() + pen.width() * i / waves, x1 = pen.left() + pen.width() * (i + 1) / waves;
    const double swing = (i % 2 == 0 ? 1 : -1) * 0.62 * pen.depth();
    pen.Curve({x0, 0}, {x0 + 0.3 * (x1 - x0), swing}, {x1 - 0.3 * (x1 - x0), swing}, {x1, 0}, Line::kOutline);
  }
}

void DrawTelevision(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kDeep, Line::kOutline, 0.01);
  pen.Area({0.97 * pen.left(), 0.3 * pen.front(), 0.97 * pen.right(), pen.front()}, Tone::kGlass, Line::kFaint);
}

void DrawWallLamp(SymbolPen& pen) {
  pen.Area({0.6 * pen.left(), pen.back(), 0.6 * pen.right(), 0}, Tone::kBody, Line::kOutline);
  pen.Oval({0, 0.1 * pen.depth()}, pen.width() / 2, 0.4 * pen.depth(), Tone::kPale, Line::kOutline);
}

void DrawPendant(SymbolPen& pen) {
  const double r = pen.smaller() / 2;
  pen.Oval({0, 0}, pen.width() / 2, pen.depth() / 2, Tone::kNone, Line::kDashed);
  pen.Segment({-0.35 * r, 0}, {0.35 * r, 0});
  pen.Segment({0, -0.35 * r}, {0, 0.35 * r});
}

void DrawChandelier(SymbolPen& pen) {
  const double rx = pen.width() / 2, ry = pen.depth() / 2;
  pen.Oval({0, 0}, 0.84 * rx, 0.84 * ry, Tone::kNone, Line::kDashed);
  pen.Oval({0, 0}, 0.2 * rx, 0.2 * ry, Tone::kNone, Line::kDetail);
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * pi * i / 8;
    const Point at{0.84 * rx * std::cos(angle), 0.84 * ry * std::sin(angle)};
    pen.Segment({0.24 * at.x, 0.24 * at.y}, {0.8 * at.x, 0.8 * at.y}, Line::kFaint);
    pen.Oval(at, 0.16 * rx, 0.16 * ry, Tone::kNone, Line::kDetail);
  }
}

void DrawCeilingFan(SymbolPen& pen) {
  const double rx = pen.width() / 2, ry = pen.depth() / 2;
  pen.Oval({0, 0}, rx, ry, Tone::kNone, Line::kDashed);
  for (int i = 0; i < 4; ++i) {
    const double angle = 2 * pi * i / 4 + 0.4;
    const Point a{0.95 * rx * std::cos(angle - 0.13), 0.95 * ry * std::sin(angle - 0.13)};
    const Point b{0.95 * rx * std::cos(angle + 0.13), 0.95 * ry * std::sin(angle + 0.13)};
    const Point blade[] = {{0.1 * a.x, 0.1 * a.y}, a, b, {0.1 * b.x, 0.1 * b.y}};
    pen.Shape(blade, Tone::kNone, Line::kDetail);
  }
  pen.Oval({0, 0}, 0.12 * rx, 0.12 * ry, Tone::kNone, Line::kDetail);
}

}  // namespace flair::renderer
