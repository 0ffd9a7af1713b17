// SPDX-License-Identifier: GPL-3.0-or-later
// Lays a rug half under an object and half before it.
//   cost = |c_rug - m|^2 + (1 - cos^2 a)                                                                       [m2]
//   m  middle of the object's front;  a  angle between the rug's longer side and the object's back edge
// Zero exactly when the rug is centred on the front edge, its longer side along it; a half turn is the same. The
// released rug_under_central_forward compares directed edges by arccos without clipping (SEMANTICS.md section 6).
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct RugUnderForward {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  Footprint rug;
  Footprint object;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
