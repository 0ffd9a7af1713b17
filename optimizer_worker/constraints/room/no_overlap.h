// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two objects out of each other.
//   cost = max(-gap(A, B), 0)^2                                                                   [m2]
//   gap  signed gap of the two rectangles (measure/gap.h): minus the length of the shortest push that parts them
// Zero exactly when they are apart or touch; continuously differentiable at contact; pushes apart in the cheapest
// direction. The paper's Eq. no_overlap sums squared edge lengths of the intersection, which jumps from 0 to 10 at
// contact and has no usable slope (SEMANTICS.md section 5).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct NoOverlap {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint first;
  Footprint second;
  // Their circles meet when the centres are closer than this.
  double reach_m = CircumscribedRadius(first) + CircumscribedRadius(second);

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
