// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object in front of another.
//   cost = out(gap, [distance / 2, distance])^2 + max(|u| - play, 0)^2 + [parallel] sin^2(theta_1 - theta_2)    [m2]
//   gap   air between the target's front and the nearest corner of the object, along the target's front direction
//   u     lateral offset of the object's centre from the target's middle line
//   play  half of what the narrower can move within the wider, |w_1 - w_2| / 4
// Zero exactly when the object stands before the target's middle, at distance_m or down to half of it, square to it (a
// half turn is the same). The released io_infront asks for one point, counts a side shift like a distance and jumps
// where headings wrap (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct InFrontOf {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint target;
  double distance_m;
  bool parallel;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
