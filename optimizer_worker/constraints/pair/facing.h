// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object towards another.
//   cost = (|FL - c| - |BL - c|)+^2 + (|FR - c| - |BR - c|)+^2 + (d_left + d_right - w)^2                      [m2]
//   c                 centre of the target;  FL, BL, FR, BR  front and back corners of the object
//   d_left, d_right   distances of c from the lines through its left and right side, w its width
// With both, the same with roles swapped and (f1 . f2 + 1)^2. Zero exactly when the target's centre is ahead within the
// strip of the object's width (with both: facing each other). As the released io_facing.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct Facing {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint target;
  bool both;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
