// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object above a floor object.
//   cost = min over walls of  (on_wall) + max(|m_1 - m_2| - play, 0)^2 + max(p - max(p_min, 0.15), 0)^2            [m2]
//   on_wall   cost of hanging on that wall, off its openings (room/on_wall.h)
//   m_1, m_2  middles of the two along the wall;  p, p_min  as in on_wall_near.h
//   play      0 for the only thing above the target, else what it can move above it: several share the place
// Zero exactly when it hangs on the wall that the target stands at, above its middle.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct OnWallAbove {
  static constexpr int kObjects = 2;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  std::vector<HangingWall> places;
  bool shares_place;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
