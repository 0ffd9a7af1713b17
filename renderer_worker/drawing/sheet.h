// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "renderer_worker/drawing/plan.h"

namespace flair::renderer {

// A dimension line outside the room, in S: `ticks_mm` along it, one text between each two.
struct DimensionString {
  Point direction;  // unit, along the line
  Point outward;    // unit, away from the wall
  std::vector<Point> ticks_mm;
  std::vector<std::string> texts;
  double reach_mm = 0;  // from the wall's face to the line
};

// Paper and scale: A3, turned whichever way shows the room larger. The plan has its own area; the key and the title
// have a column on the right (landscape) or a strip below (portrait).
struct Sheet {
  Size size_mm;
  Box plan_mm;
  Box side_mm;
  bool portrait = false;
  int scale = 50;   // 1:scale
  Point origin_mm;  // of R

  double mm_per_m() const { return 1000.0 / scale; }
  Point ToSheet(Point point_m) const {
    return {origin_mm.x + point_m.x * mm_per_m(), origin_mm.y - point_m.y * mm_per_m()};
  }
};

inline constexpr double kWallThicknessM = 0.14;
// Thick enough to be seen as a pair of lines at any scale, and no heavier than the drawing can bear.
inline double WallThicknessMm(const Sheet& sheet) { return std::clamp(kWallThicknessM * sheet.mm_per_m(), 2.0, 7.0); }

// The largest usual scale at which room, outward doors and dimension strings fit the plan area.
Sheet ChooseSheet(const Plan& plan);

// Dimension strings: a chain along each wall with openings, and the length of every wall that no parallel one tells.
std::vector<DimensionString> LayOutDimensions(const Plan& plan, const Sheet& sheet);

}  // namespace flair::renderer
