// SPDX-License-Identifier: GPL-3.0-or-later
// Gives two objects the same heading: cost = 1 - cos(theta_1 - theta_2). Zero exactly when both face the same way. The
// released io_parallel squares the difference of headings reduced to [0, 2 pi), which jumps by 39 at the wrap
// (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

struct Parallel {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
