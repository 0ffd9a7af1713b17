// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object away from another: cost = max(cos a - cos 45, 0)^2, a the angle between its front and the direction
// from its centre to the target's. Zero exactly when the target is at least 45 degrees off its look. The released
// io_not_facing is identically zero (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct NotFacing {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
