// SPDX-License-Identifier: GPL-3.0-or-later
// Stands two objects at a right angle, with a third object before both when one is named.
//   cost = (f1 . f2)^2 + sum over both of  max(|u_i| - w_i / 4, 0)^2 + max(-v_i, 0)^2                          [m2]
//   f1, f2    front directions;  u_i, v_i  how far right and ahead of object i the centre object is;  w_i  its width
// The sum is there with `center` only. Zero exactly when they stand at a right angle and the centre object is ahead of
// the middle half of both. The released io_perp drops object 0, reads the pose of another object and divides by zero
// for parallel ones (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct RightAngle {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

struct PerpendicularAround {
  static constexpr int kObjects = 3;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint target;

  template <typename T>
  T operator()(const Frames<T, 3>& frames) const;
};

}  // namespace flair::optimizer
