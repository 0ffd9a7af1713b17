// SPDX-License-Identifier: GPL-3.0-or-later
// Lays an object under the middle of another: cost = |c1 - c2|^2 + sin^2(theta_1 - theta_2) [m2]. Zero exactly when the
// centres meet and the sides are parallel; a half turn is the same. The released io_under_central compares headings
// that wrap.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct UnderCenter {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
