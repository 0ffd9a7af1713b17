// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object between two others.
//   cost = max(|lateral| - play, 0)^2 + max(-s_1, 0)^2 + max(-s_2, 0)^2                                        [m2]
//   lateral  distance of its centre from the line through the centres of the two;  play  a quarter of its shorter side
//   s_1, s_2 how far its centre is from either, along that line, less half its shorter side
// Zero exactly when its centre lies on the way from one to the other. The released io_between asks it to touch both,
// with all three facing the same way (SEMANTICS.md section 4).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct Between {
  static constexpr int kObjects = 3;
  static constexpr bool kOnlyRelative = true;
  Footprint footprint;

  template <typename T>
  T operator()(const Frames<T, 3>& frames) const;
};

}  // namespace flair::optimizer
