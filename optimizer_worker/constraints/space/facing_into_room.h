// SPDX-License-Identifier: GPL-3.0-or-later
// Turns an object's front into the room.
//   cost = max(a - pi / 4, 0)^2                                                                              [rad2]
//   a  angle between its front and the direction from its centre to the room's centre
// Zero exactly when it faces the middle of the room within 45 degrees; any heading will do in the very middle. The
// released ind_facing_into_room is this with arccos without clipping, which scores 0 for many objects that are turned
// exactly away.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

struct FacingIntoRoom {
  static constexpr int kObjects = 1;
  Vec2<double> room_center;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
