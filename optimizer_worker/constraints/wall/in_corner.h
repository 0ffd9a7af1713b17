// SPDX-License-Identifier: GPL-3.0-or-later
// Puts an object into a corner of the room.
//   cost = min over corners K and the two ways round of  |C - K|^2 + (1 - cos a)                           [m2]
//   C  the object's corner between the given side and its neighbour;  a  angle between the side and its wall
// Zero exactly when the given side lies on one wall of the corner and the neighbouring side on the other. Only corners
// that open inwards count. The released ind_in_corner wants the object across the corner at 45 degrees and punishes the
// flush one (SEMANTICS.md section 3).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

// A corner of the room where the side can lie on the wall before or after it.
struct RoomCorner {
  Vec2<double> point;
  // The wall that the side lies on.
  Wall wall;
  // Whether the corner is at that wall's end (at the object's right when its back is on the wall).
  bool at_end;
};

struct InCorner {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  Side side;
  std::vector<RoomCorner> corners;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
