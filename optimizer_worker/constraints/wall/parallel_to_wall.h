// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object so that its sides run along a wall.
//   cost = min over walls of sin^2(2 (theta - phi)) / 4                                                    [rad2]
//   theta  heading of the object;  phi  direction of the wall
// Zero exactly when two sides of the object are parallel to a wall, near that the square of the angle that lacks. Kinks
// half way between the directions of two walls; a rectangle has one direction. Models call it (ind_parallel_to_wall);
// the released library has no such function, only `aligned` for all objects.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct ParallelToWall {
  static constexpr int kObjects = 1;
  // Unit vectors along the walls, one of those that are parallel or at right angles.
  std::vector<Vec2<double>> directions;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
