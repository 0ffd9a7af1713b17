// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

// Dimension strings: a chain along each wall with openings, the length of every wall that no parallel one tells, and
// the extent of the room where none of its walls has it. None when the layer is not drawn.
std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet);

}  // namespace flair::renderer
