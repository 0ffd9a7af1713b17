// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs an object above another: cost = |c1 - c2|^2 [m2], as the released ceiling_above. Zero exactly when the centres
// meet.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct CeilingAbove {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
