// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object out of the way of doors.
//   cost = sum over doors of  depth(swing)^2 + depth(passage)^2                                   [m2]
//   swing    the sector that the leaf really sweeps, hinge and angle as given (doors that open inwards)
//   passage  the opening's width, kPassage deep into the room, so that one can step through
//   depth    the shortest push out of the area that does not go through the wall
// Zero exactly when swings and passages are free. The paper's door term uses a square twice as wide as the door in one
// function and three different zones in all (SEMANTICS.md section 10).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"
#include "room/scene/room.h"

namespace flair::optimizer {

// How far in front of a door the floor stays free for stepping through.
inline constexpr double kPassage_m = 0.6;

// What the leaves sweep, as convex areas that reach behind the wall.
std::vector<ConvexPiece> SwingPieces(const Room& room);

// Swings and passages of all doors, as convex areas that reach behind the wall.
std::vector<ConvexPiece> DoorAreas(const Room& room, double passage_m = kPassage_m);

struct DoorClearFormula {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<ConvexPiece> areas;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
