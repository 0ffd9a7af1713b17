// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// A dimension line outside the room, in S: `ticks_mm` along it, one text between each two.
struct DimensionString {
  Point direction;  // unit, along the line
  Point outward;    // unit, away from the wall
  std::vector<Point> ticks_mm;
  std::vector<std::string> texts;
  double reach_mm = 0;  // from the wall's face to the line
};

// A number needs this much between its ticks; shorter first and last pieces carry it beyond the end of the line.
inline constexpr double kLeastPieceMm = 8;
inline double PieceMm(const DimensionString& string, size_t piece) {
  return std::hypot(string.ticks_mm[piece + 1].x - string.ticks_mm[piece].x,
                    string.ticks_mm[piece + 1].y - string.ticks_mm[piece].y);
}

// Dimension strings: a chain along each wall with openings, the length of every wall that no parallel one tells, and
// the extent of the room where none of its walls has it. None when the layer is not drawn.
std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet);

// A free distance inside the room: straight ahead from the middle of a large piece's front to the next solid piece or
// wall. Room frame R.
struct Clearance {
  Point from_m;
  Point to_m;
  double length_m = 0;
};

// The key clearances of [0.35, 2.5] m, of the largest pieces first, at most eight; of two that run beside each other
// over the same floor only one. None when the layer of dimensions is not drawn.
std::vector<Clearance> FindClearances(const Plan& plan);

// Those of them that are long enough on this paper to carry their number.
std::vector<Clearance> ShownClearances(const Plan& plan, const Sheet& sheet);

// The paper that the number of a clearance takes.
Box ClearanceTextBox(const Canvas& canvas, const Sheet& sheet, const Clearance& clearance);

void DrawClearances(Canvas& canvas, const Plan& plan, const Sheet& sheet);

}  // namespace flair::renderer
