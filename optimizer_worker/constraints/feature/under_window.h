// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object under a window.
//   cost = min over windows of  out(gap, [0, 0.1])^2 + max(|offset| - |L - w| / 2, 0)^2 + (1 - cos a)          [m2]
//   gap     distance of the object's side that looks at the wall, offset  of that side's middle from the window's
//   middle L, w    lengths of that side and of the window;  a  angle between side and wall
// Zero exactly when the object stands at the wall (within 10 cm), square to it, its side within the window's interval
// or the other way round. The released ind_under_window reaches zero only with the centre on the wall (SEMANTICS.md
// section 3).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

// A window as an interval of its wall.
struct WindowPlace {
  Wall wall;
  double middle_m;
  double width_m;
};

struct UnderWindow {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<WindowPlace> windows;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
