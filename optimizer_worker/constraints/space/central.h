// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object in the middle of the room.
//   cost = min(hx^2, hy^2), or hx^2 + hy^2 with both                                                         [m2]
//   hx, hy  distance of the centre outside the middle third of the room's bounding box, east-west and north-south
// Zero exactly when the centre is in the middle third along one axis (or both). The released ind_central multiplies hx
// and hy, so that it is flat along either third, and adds a heading term that whole-room alignment has already.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/polygon.h"

namespace flair::optimizer {

struct Central {
  static constexpr int kObjects = 1;
  BoundingBox box;
  bool both;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
