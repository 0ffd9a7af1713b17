// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <vector>

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

}  // namespace flair::renderer
