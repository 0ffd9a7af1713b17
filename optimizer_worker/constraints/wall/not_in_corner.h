// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object out of the corners of the room.
//   cost = sum over corners K of max(min - max(|d_a|, |d_b|), 0)^2                                          [m2]
//   d_a, d_b  least signed distance of the object's corners to the lines of the two walls that meet at K
// Zero exactly when at every corner the object is at least min_distance_m from one of the two walls: it may stand
// against a wall, but not where two meet. Only corners that open inwards count. Kinks where the other wall is the
// farther one and where another of the object's corners is the nearest. Models call it (ind_not_in_corner); the
// released library has no such function.
#pragma once

#include <utility>
#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct NotInCorner {
  static constexpr int kObjects = 1;
  Footprint footprint;
  double min_distance_m;
  // The walls before and after each corner.
  std::vector<std::pair<Wall, Wall>> corners;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
