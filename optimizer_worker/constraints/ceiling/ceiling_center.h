// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs an object from the middle of the ceiling: cost = |c - c_room|^2 [m2], as the released center_ceiling. The
// room's centre is its centre of mass. Zero exactly there.
#pragma once

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

struct CeilingCenter {
  static constexpr int kObjects = 1;
  Vec2<double> room_center;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
