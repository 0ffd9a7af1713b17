// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps objects from floating in the middle of the room without reason.
//   cost = max(d - r - T, 0)^2                                                                     [m2]
//   d  distance of the object's centre to the nearest wall, r half its diagonal, T = 0.5 m
// [Paper] Eq. wall_attraction without its factor 1/lambda_2. Zero exactly when the object is within T of a wall. The
// released term also asks for the back to be the nearest side; that is against_wall's matter.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct WallAttractionFormula {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  std::vector<Wall> walls;
  // r + T.
  double free_m;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
