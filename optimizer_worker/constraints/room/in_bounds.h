// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object on the floor.
//   cost = sum over corners C and half-planes of the floor's hull of max(-h(C), 0)^2 + sum over pockets of depth^2 [m2]
//   h(C)   signed distance of the corner from the half-plane's edge, positive inside
//   depth  penetration of the rectangle into a part of the hull that is not floor (none in a rectangle)
// Zero exactly when the whole rectangle is on the floor. For a rectangular room [Paper] Eq. in_bounds: the released
// function is 10 times this. The weight is the solver's.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct InBoundsFormula {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  FloorShape floor;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
