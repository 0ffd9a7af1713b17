// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two objects near each other: cost = max(gap - max, 0)^2 [m2], gap the distance between the two rectangles.
// Zero exactly when they are at most max_distance_m apart. The released io_near measures from centre to centre
// (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct Near {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  double max_distance_m;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
