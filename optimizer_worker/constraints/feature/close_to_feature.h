// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object, or one of its sides, close to a door, window or socket.
//   cost = min over features of that kind of  max(d - max, 0)^2                                              [m2]
//   d  distance between the rectangle (or the side) and the feature's interval on the wall
// Zero exactly when some feature is within max_distance_m. The released ind_close_to_fixed_object measures to a door's
// hinge and does not square the excess (SEMANTICS.md section 3).
#pragma once

#include <optional>
#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct CloseToFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::optional<Side> side;
  double max_distance_m;
  std::vector<ConvexPiece> features;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
