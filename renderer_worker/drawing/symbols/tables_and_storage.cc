// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/symbol.h"

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

}  // namespace

std::span<const Symbol> TableAndStorageSymbols() {
  static constexpr Symbol kSymbols[] = {{"table", DrawTable},
                                        {"round_table", DrawRoundTable},
                                        {"coffee_table", DrawCoffeeTable},
                                        {"nightstand", DrawNightstand},
                                        {"desk", DrawDesk},
                                        {"vanity", DrawVanity},
                                        {"workbench", DrawWorkbench},
                                        {"pool_table", DrawPoolTable},
                                        {"wardrobe", DrawWardrobe},
                                        {"dresser", DrawDresser},
                                        {"cabinet", DrawCabinet},
                                        {"bookshelf", DrawBookshelf},
                                        {"shelf", DrawShelf},
                                        {"rack", DrawRack},
                                        {"trunk", DrawTrunk},
                                        {"barrel", DrawBarrel},
                                        {"basket", DrawBasket}};
  return kSymbols;
}

}  // namespace flair::renderer
