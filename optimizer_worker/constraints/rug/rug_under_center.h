// SPDX-License-Identifier: GPL-3.0-or-later
// Centres a rug under an object: cost = |c_rug - c_object|^2 [m2], as the released rug_under_central. Zero exactly when
// the centres meet.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct RugUnderCenter {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
