// SPDX-License-Identifier: GPL-3.0-or-later
// Lets daylight fall on an object from its left or right, as on a desk: a window ahead dazzles, one behind is mirrored
// by the screen.
//   cost = min over windows and both sides of
//          max(1 - cos a - (1 - cos 30 deg), 0)^2 + out(u, window +- L / 2)^2 + out(h, [0, max_distance_m])^2    [m2]
//   a     angle between the side's outward normal and the straight look at the window's wall; its term has no unit
//   u, h  of the side's middle: metres along the wall, and from it;  L  length of the side
//   out(x, interval)  how far x is outside of it
// Zero exactly when one of the two sides looks at a window within 30 degrees, lies before it at least by its edge and
// is at most max_distance_m from its wall. Continuously differentiable but where another window or side takes over.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct DaylightFromSide {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;

  // One way for the light: through a window, an interval of its wall, onto a side.
  struct Light {
    Wall wall;
    double start_m;
    double end_m;
    Side side;
  };

  Footprint footprint;
  std::vector<Light> lights;
  double max_distance_m;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
