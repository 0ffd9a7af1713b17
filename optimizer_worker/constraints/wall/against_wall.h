// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps one side of an object (its back by default) on a wall.
//   cost = min over walls of  gap^2 + (1 - cos a) + overhang^2                                    [m2]
//   gap       signed distance of the side's middle to the wall's line, so that beyond the wall is an error too
//   a         angle between the side's outward normal and the direction into the wall
//   overhang  how far the side sticks out beyond the wall's ends (matters at inner corners)
// Zero exactly when the whole side lies on the wall. Smooth but where the nearest wall changes.
// The released ind_next_to_wall multiplies the distances to two walls, so that the same gap costs more in a larger
// room; SEMANTICS.md section 3 names this form as correct.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct AgainstWall {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  Side side;
  // The walls to choose from.
  std::vector<Wall> walls;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
