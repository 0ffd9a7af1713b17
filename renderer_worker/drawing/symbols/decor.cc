// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/symbol.h"

namespace flair::renderer {
namespace {

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

void DrawRug(SymbolPen& pen) {
  // Fringes at the ends of the longer side, a double border, a pale medallion.
  const bool along = pen.width() >= pen.depth();
  const double fringe = std::min(0.05, 0.05 * pen.smaller());
  const Box cloth = along ? Box{pen.left() + fringe, pen.back(), pen.right() - fringe, pen.front()}
                          : Box{pen.left(), pen.back() + fringe, pen.right(), pen.front() - fringe};
  const int threads = std::clamp(static_cast<int>(pen.smaller() / 0.045), 6, 90);
  for (int i = 0; i <= threads; ++i) {
    const double share = static_cast<double>(i) / threads;
    for (double side : {-1.0, 1.0}) {
      if (along) {
        const double y = pen.back() + share * pen.depth();
        pen.Segment({side * (pen.right() - fringe), y}, {side * pen.right(), y}, Line::kFaint);
      } else {
        const double x = pen.left() + share * pen.width();
        pen.Segment({x, side * (pen.front() - fringe)}, {x, side * pen.front()}, Line::kFaint);
      }
    }
  }
  pen.Area(cloth, Tone::kLight, Line::kDetail);
  const double border = std::min(0.13, 0.09 * pen.smaller());
  pen.Area(cloth.Grown(-0.35 * border), Tone::kBody, Line::kFaint);
  pen.Area(cloth.Grown(-border), Tone::kLight, Line::kFaint);
  pen.Area(cloth.Grown(-1.35 * border), Tone::kNone, Line::kFaint);
  const double w = 0.22 * cloth.width(), d = 0.22 * cloth.height();
  const Point outer[] = {{0, -d}, {w, 0}, {0, d}, {-w, 0}};
  pen.Shape(outer, Tone::kBody, Line::kFaint);
  const Point inner[] = {{0, -0.6 * d}, {0.6 * w, 0}, {0, 0.6 * d}, {-0.6 * w, 0}};
  pen.Shape(inner, Tone::kLight, Line::kFaint);
}

void DrawRoundRug(SymbolPen& pen) {
  const double rx = pen.width() / 2, ry = pen.depth() / 2;
  pen.Oval({0, 0}, rx, ry, Tone::kLight, Line::kDetail);
  for (double share : {0.9, 0.82, 0.5, 0.44}) {
    pen.Oval({0, 0}, share * rx, share * ry, share == 0.9 || share == 0.5 ? Tone::kBody : Tone::kLight, Line::kFaint);
  }
}

void DrawMat(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kDetail, std::min(0.05, 0.1 * pen.smaller()));
  pen.Area(pen.whole().Grown(-0.08 * pen.smaller()), Tone::kNone, Line::kFaint, std::min(0.04, 0.08 * pen.smaller()));
  const bool along = pen.width() >= pen.depth();
  const int stripes = std::clamp(static_cast<int>(std::max(pen.width(), pen.depth()) / 0.16), 3, 16);
  for (int i = 1; i < stripes; ++i) {
    const double share = static_cast<double>(i) / stripes - 0.5;
    along
        ? pen.Segment({share * pen.width(), 0.38 * pen.back()}, {share * pen.width(), 0.38 * pen.front()}, Line::kFaint)
        : pen.Segment({0.38 * pen.left(), share * pen.depth()}, {0.38 * pen.right(), share * pen.depth()},
                      Line::kFaint);
  }
}

void DrawCushion(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kLight, Line::kOutline, 0.28 * pen.smaller());
  pen.Area(pen.whole().Grown(-0.14 * pen.smaller()), Tone::kNone, Line::kFaint, 0.22 * pen.smaller());
  pen.Circle({0, 0}, 0.05 * pen.smaller(), Tone::kDark, Line::kFaint);
}

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

}  // namespace

std::span<const Symbol> DecorSymbols() {
  static constexpr Symbol kSymbols[] = {{"plant", DrawPlant},
                                        {"lamp", DrawLamp},
                                        {"screen", DrawScreen},
                                        {"laptop", DrawLaptop},
                                        {"books", DrawBooks},
                                        {"vase", DrawVase},
                                        {"tray", DrawTray},
                                        {"candles", DrawCandles},
                                        {"orb", DrawOrb},
                                        {"rug", DrawRug},
                                        {"round_rug", DrawRoundRug},
                                        {"mat", DrawMat},
                                        {"cushion", DrawCushion},
                                        {"picture", DrawPicture},
                                        {"mirror", DrawMirror},
                                        {"curtain", DrawCurtain},
                                        {"television", DrawTelevision},
                                        {"wall_lamp", DrawWallLamp},
                                        {"pendant", DrawPendant},
                                        {"chandelier", DrawChandelier},
                                        {"ceiling_fan", DrawCeilingFan}};
  return kSymbols;
}

}  // namespace flair::renderer
