// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {

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

}  // namespace flair::renderer
