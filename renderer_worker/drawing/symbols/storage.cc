// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {
namespace {

// Fronts of drawers or doors seen from above: a strip along the front edge, divided, a knob for each.
void DrawFronts(SymbolPen& pen, double strip, double target_m) {
  const int count = std::clamp(static_cast<int>(std::lround(pen.width() / target_m)), 1, 8);
  pen.Area({pen.left(), pen.front() - strip, pen.right(), pen.front()}, Tone::kDark, Line::kDetail);
  for (int i = 0; i < count; ++i) {
    const double x = pen.left() + pen.width() * (i + 0.5) / count;
    if (i > 0)
      pen.Segment({x - pen.width() / (2 * count), pen.front() - strip}, {x - pen.width() / (2 * count), pen.front()});
    const double half = std::min(0.05, 0.2 * pen.width() / count);
    pen.Area({x - half, pen.front() - 0.3 * strip, x + half, pen.front()}, Tone::kDeep, Line::kNone);
  }
}

}  // namespace

void DrawWardrobe(SymbolPen& pen) {
  const double door = std::min(0.04, 0.1 * pen.depth());
  pen.Area(pen.whole(), Tone::kBody);
  pen.Area({pen.left() + 0.02, pen.back() + 0.02, pen.right() - 0.02, pen.front() - door}, Tone::kLight, Line::kDetail);
  // The rail with its hangers; the doors along the front.
  const double y = (pen.back() + pen.front() - door) / 2;
  const double reach = std::min(0.2, 0.33 * pen.depth());
  pen.Segment({pen.left() + 0.02, y}, {pen.right() - 0.02, y}, Line::kOutline);
  const int hangers = std::clamp(static_cast<int>(pen.width() / 0.13), 2, 40);
  for (int i = 1; i < hangers; ++i) {
    const double x = pen.left() + pen.width() * i / hangers, lean = 0.016 * ((i * 7) % 5 - 2);
    pen.Segment({x - lean, y - reach}, {x + lean, y + reach});
  }
  const int doors = std::clamp(static_cast<int>(std::lround(pen.width() / 0.55)), 1, 8);
  pen.Area({pen.left(), pen.front() - door, pen.right(), pen.front()}, Tone::kDark, Line::kDetail);
  for (int i = 1; i < doors; ++i) {
    const double x = pen.left() + pen.width() * i / doors;
    pen.Segment({x, pen.front() - door}, {x, pen.front()}, Line::kOutline);
  }
}

void DrawDresser(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.015);
  pen.Area(pen.whole().Grown(-std::min(0.03, 0.07 * pen.smaller())), Tone::kNone, Line::kFaint);
  DrawFronts(pen, std::min(0.055, 0.14 * pen.depth()), 0.55);
}

void DrawCabinet(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.01);
  DrawFronts(pen, std::min(0.05, 0.13 * pen.depth()), 0.5);
  pen.Segment({pen.left(), pen.back()}, {pen.right(), pen.front() - std::min(0.05, 0.13 * pen.depth())}, Line::kFaint);
}

void DrawBookshelf(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody);
  const double side = std::min(0.025, 0.04 * pen.width());
  const double y0 = pen.back() + 0.1 * pen.depth();
  pen.Area({pen.left() + side, y0, pen.right() - side, pen.front()}, Tone::kPale, Line::kDetail);
  // Book spines of uneven thickness and depth; a gap now and then.
  double x = pen.left() + side;
  for (int i = 0; i < 400 && x < pen.right() - side - 0.012; ++i) {
    const double thickness = 0.026 + 0.009 * ((i * 7 + i * i) % 5);
    if ((i * 11) % 13 == 6) {
      x += 0.05;
      continue;
    }
    const double end = std::min(x + thickness, pen.right() - side);
    const double depth = pen.depth() * (0.52 + 0.07 * ((i * 5) % 4));
    const Tone tones[] = {Tone::kLight, Tone::kDark, Tone::kBody, Tone::kPale};
    pen.Area({x, y0, end, y0 + depth}, tones[(i * 3 + i / 4) % 4], Line::kFaint);
    x = end;
  }
  pen.Segment({pen.left(), pen.front()}, {pen.right(), pen.front()}, Line::kOutline);
}

void DrawShelf(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight);
  const int bays = std::clamp(static_cast<int>(std::lround(pen.width() / 0.45)), 1, 10);
  for (int i = 1; i < bays; ++i) {
    const double x = pen.left() + pen.width() * i / bays;
    pen.Segment({x, pen.back()}, {x, pen.front()});
  }
  const double y = pen.back() + 0.14 * pen.depth();
  pen.Segment({pen.left(), y}, {pen.right(), y}, Line::kDetail);
}

void DrawRack(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kPale, Line::kDetail, 0.02);
  pen.Segment({pen.left(), 0}, {pen.right(), 0}, Line::kOutline);
  const int hooks = std::clamp(static_cast<int>(pen.width() / 0.12), 2, 20);
  for (int i = 0; i < hooks; ++i) {
    const double x = pen.left() + pen.width() * (i + 0.5) / hooks;
    pen.Segment({x, -0.3 * pen.depth()}, {x, 0.3 * pen.depth()});
    pen.Circle({x, 0.3 * pen.depth()}, std::min(0.015, 0.08 * pen.depth()), Tone::kDeep, Line::kNone);
  }
}

void DrawTrunk(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.02);
  for (double share : {0.2, 0.8}) {
    const double x = pen.left() + share * pen.width(), half = std::min(0.025, 0.04 * pen.width());
    pen.Area({x - half, pen.back(), x + half, pen.front()}, Tone::kDark, Line::kDetail);
  }
  pen.Segment({pen.left(), pen.back() + 0.12 * pen.depth()}, {pen.right(), pen.back() + 0.12 * pen.depth()},
              Line::kFaint);
  const double lock = std::min(0.05, 0.1 * pen.width());
  pen.Area({-lock / 2, pen.front() - lock, lock / 2, pen.front()}, Tone::kDeep, Line::kNone);
}

void DrawBarrel(SymbolPen& pen) {
  pen.Oval({0, 0}, pen.width() / 2, pen.depth() / 2, Tone::kDark, Line::kOutline);
  pen.Oval({0, 0}, 0.42 * pen.width(), 0.42 * pen.depth(), Tone::kLight, Line::kDetail);
  for (int i = -2; i <= 2; ++i) {
    const double x = 0.15 * i * pen.width();
    const double y = 0.42 * pen.depth() * std::sqrt(1 - (0.15 * i / 0.42) * (0.15 * i / 0.42));
    pen.Segment({x, -y}, {x, y}, Line::kFaint);
  }
  pen.Circle({0.1 * pen.width(), 0.18 * pen.depth()}, 0.05 * pen.smaller(), Tone::kDeep);
}

void DrawBasket(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline, 0.3 * pen.smaller());
  pen.Area(pen.whole().Grown(-0.12 * pen.smaller()), Tone::kLight, Line::kDetail, 0.24 * pen.smaller());
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * std::numbers::pi * i / 16, c = std::cos(angle), s = std::sin(angle);
    pen.Segment({0.38 * pen.width() * c, 0.38 * pen.depth() * s}, {0.46 * pen.width() * c, 0.46 * pen.depth() * s},
                Line::kFaint);
  }
}

}  // namespace flair::renderer
