// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object towards a door, window or socket.
//   cost = min over features of  max(u_end, 0)^2 + max(-u_start, 0)^2 + max(-v, 0)^2                          [m2]
//   u_start, u_end  how far right of the object's line of sight the feature's two ends are (the start is on the right
//   as seen
//                   from the room);  v  how far ahead its middle is
// Zero exactly when the straight look ahead meets the feature. A socket is taken 0.3 m wide.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/polygon.h"

namespace flair::optimizer {

struct FacesFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  std::vector<Segment> features;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
