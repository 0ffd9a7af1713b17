// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object near a floor object.
//   cost = min over walls of  (on_wall) + max(s - 0.5, 0)^2 + max(p - max(p_min, 0.5), 0)^2                      [m2]
//   on_wall  cost of hanging on that wall, off its openings (room/on_wall.h)
//   s        gap between the two along the wall;  p  distance of the target's nearest corner to that wall, p_min to any
//   wall
// Zero exactly when it hangs on the target's nearest wall (or one within half a metre of it), at most half a metre
// beside it. The released on_wall_near adds the squared distance of the centres and is never zero (SEMANTICS.md section
// 6).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct OnWallNear {
  static constexpr int kObjects = 2;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  std::vector<HangingWall> places;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
