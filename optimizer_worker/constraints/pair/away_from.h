// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two objects apart: cost = max(min - gap, 0)^2 [m2], gap the signed gap between the two rectangles.
// Zero exactly when they are at least min_distance_m apart. The released io_away_from is exp(min - centre distance),
// never zero (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct AwayFrom {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  double min_distance_m;
  // Their centres are at least this far apart: nothing to do.
  double reach_m = min_distance_m + CircumscribedRadius(object) + CircumscribedRadius(target);

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
