// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object away from all doors, windows or sockets.
//   cost = sum over features of that kind of  max(min - gap, 0)^2                                            [m2]
//   gap  signed gap between the rectangle and the feature's interval on the wall
// Zero exactly when every one is at least min_distance_m away. The released ind_away_from_fixed_object measures from
// centre to hinge less half a diagonal (SEMANTICS.md section 3).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct AwayFromFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  double min_distance_m;
  std::vector<ConvexPiece> features;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
