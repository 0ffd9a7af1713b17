// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/plan.h"

namespace flair::renderer {

// Paper and scale, turned whichever way shows the room larger. The plan has its own area; the key and the title have a
// column on the right (landscape) or a strip below (portrait).
struct Sheet {
  std::string_view paper = "A3";
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

// How far doors of a wall swing out of the room, millimetres of paper.
double OutwardReachMm(const Plan& plan, const Sheet& sheet, int wall);

// What walls, outward doors and dimension lines take of the paper at the sheet's scale and origin.
Box PaperNeeded(const Plan& plan, const Sheet& sheet);

// The common scales, largest first: 10 for 1:10.
std::span<const int> CommonScales();

// The paper without scale and origin. `paper` is one that is known.
Sheet EmptySheet(v1::PaperSize paper, bool portrait, int scale);

// The paper of the options at their scale, or at the largest common one at which room, outward doors and dimension
// lines fit. INVALID_ARGUMENT when a given scale is out of [5, 1000] or too large for the paper (the message says which
// one would fit), or when no scale is small enough.
absl::StatusOr<Sheet> ChooseSheet(const Plan& plan, const v1::RenderOptions& options = {});

}  // namespace flair::renderer
