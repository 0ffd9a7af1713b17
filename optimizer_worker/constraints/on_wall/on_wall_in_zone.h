// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object in a zone.
//   cost = (zone cost of measure/zones.h) + (cost of on_wall, room/on_wall.h)                                     [m2]
// Zero exactly when it hangs on a wall, its centre in the zone's Voronoi cell. The released on_wall_in_region is the
// first part; the second is there so that the call alone says all of its sentence.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

struct OnWallInZone {
  static constexpr int kObjects = 1;
  Footprint footprint;
  std::vector<HangingWall> places;
  std::vector<Vec2<double>> centers;
  int zone;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
