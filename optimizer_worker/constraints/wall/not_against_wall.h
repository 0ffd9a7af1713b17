// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object, or one of its sides, away from all walls.
//   cost = sum over corners C and walls of max(min - d(C, wall), 0)^2                                       [m2]
//   C  the object's corners, or the two ends of the given side;  d  signed distance to the wall's line in a convex room
// In other rooms d is the gap between the whole object and each wall, once per wall. Zero exactly when everything is at
// least min_distance_m from every wall. The released ind_not_against_wall is 10 times this, lets corners pass through
// walls and refuses the side that its own documentation names (SEMANTICS.md section 3).
#pragma once

#include <optional>
#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

struct NotAgainstWall {
  static constexpr int kObjects = 1;
  Footprint footprint;
  std::optional<Side> side;
  double min_distance_m;
  std::vector<Wall> walls;
  // The walls' lines bound the room.
  bool convex;
  // The same walls as pieces, for rooms that are not convex.
  std::vector<ConvexPiece> pieces;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
