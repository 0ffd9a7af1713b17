// SPDX-License-Identifier: GPL-3.0-or-later
// Sets a thing on one corner of another.
//   cost = overhang^2 + max(-s_u u, 0)^2 + max(-s_v v, 0)^2 + (1 - cos(theta_1 - theta_2))                      [m2]
//   u, v      its centre in the host's frame;  s_u, s_v  signs of the corner
//   overhang  of its corners over the host's edges (measure/on_top.h); of its centre when it is too large to fit
// Zero exactly when it stands wholly on the host, its centre in that quarter, facing the same way. The released
// on_top_corner pulls to the point half way to the corner and forgets things that do not touch the host.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct OnTopCorner {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint object;
  Footprint host;
  Vec2<double> signs;
  bool fits;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
