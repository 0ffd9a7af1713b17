// SPDX-License-Identifier: GPL-3.0-or-later
// Sets a thing on the middle of another: cost = |c1 - c2|^2 + (1 - cos(theta_1 - theta_2)) [m2]. Zero exactly when the
// centres meet and both face the same way. The released on_top_central compares headings that wrap.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct OnTopCenter {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
