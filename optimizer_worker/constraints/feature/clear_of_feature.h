// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object out of the space that a door, window or socket needs.
//   cost = sum over areas of depth^2                                                                         [m2]
//   areas  door: swing and passage (room/door_clear.h); window: its width, 0.5 m into the room; socket: 0.15 m wide,
//   0.1 m depth  shortest push out of the area that does not go through the wall
// Zero exactly when nothing is blocked. An object of known height that ends below a window's sill never blocks it. The
// released ind_not_block_fixed_object jumps at contact, ignores sockets and knows no heights (SEMANTICS.md section 3).
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

struct ClearOfFeature {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<ConvexPiece> areas;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
