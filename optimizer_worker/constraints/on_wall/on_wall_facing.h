// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object where a floor object looks: a television before the sofa, a mirror before the chair.
//   cost = (on_wall) + max(|u| - w / 4, 0)^2 + max(-v, 0)^2 + (1 + f1 . f2)                                       [m2]
//   on_wall  cost of hanging on the best wall (room/on_wall.h)
//   u, v     how far right and ahead of the target the object's centre is;  w  the target's width;  f1, f2  front
//   directions
// Zero exactly when it hangs on a wall straight ahead of the target's middle half, looking back at it.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct OnWallFacing {
  static constexpr int kObjects = 2;
  Footprint object;
  Footprint target;
  std::vector<HangingWall> places;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
