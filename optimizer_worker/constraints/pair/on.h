// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object wholly on another, seen from above.
//   cost = sum over corners of max(|u| - w / 2, 0)^2 + max(|v| - d / 2, 0)^2                                   [m2]
//   u, v  the object's corners in the target's frame;  w, d  the target's width and depth
// Zero exactly when no corner sticks out. The released io_on sums edges of the intersection, so that less contact costs
// less (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct On {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
