// SPDX-License-Identifier: GPL-3.0-or-later
// Weakly prefers headings along the room's axes: cost = sin^2(2 theta) / 5, [Paper] Eq. aligned, as released.
// In a room that is not an upright rectangle theta is measured from its longest wall. Zero at every quarter turn.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct AlignedFormula {
  static constexpr int kObjects = 1;
  // Unit vector along the longest wall.
  Vec2<double> axis;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
