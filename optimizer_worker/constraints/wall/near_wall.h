// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps one side of an object (its back by default) near a wall and turned to it.
//   cost = min over walls of  out(gap, [0, max])^2 + max(cos 45 - cos a, 0)^2 + out(offset, wall)^2        [m2]
//   gap     mean signed distance of the side's two ends to the wall's line
//   a       angle between the side's outward normal and the direction into the wall
//   offset  place of the side's middle along the wall
// Zero exactly when the side is at most max_distance_m from a wall that it looks at (within 45 degrees). The released
// ind_near_wall has no side, so that calls with one fail silently (SEMANTICS.md section 3).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct NearWall {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  Side side;
  double max_distance_m;
  std::vector<Wall> walls;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
