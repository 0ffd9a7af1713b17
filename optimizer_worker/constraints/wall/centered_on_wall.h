// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object's back on a wall, in the middle of it.
//   cost = min over walls of  (cost of against_wall) + (offset - L / 2)^2                                    [m2]
//   offset  place of the back's middle along the wall of length L
// Zero exactly when the back lies on the wall, centred.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct CenteredOnWall {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<Wall> walls;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
