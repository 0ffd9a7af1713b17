// SPDX-License-Identifier: GPL-3.0-or-later
// Exact feasibility of floor objects: nothing overlaps, nothing is outside the floor or in a door's swing. Rectangles
// of fixed heading are apart exactly when one of finitely many directions separates them, and along a chosen direction
// that is a linear inequality in their centres.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/solver/solver.h"
#include "room/geometry/convex_piece.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// The room as convex pieces: half-planes that every object keeps to, and convex areas that every object keeps out of.
// The same pieces as the costs in_bounds and door_clear measure.
class KeepOut {
 public:
  explicit KeepOut(const Room& room);

  const FloorShape& floor() const { return floor_; }
  // Swings of doors and the passages behind them.
  const std::vector<ConvexPiece>& door_areas() const { return door_areas_; }

 private:
  FloorShape floor_;
  std::vector<ConvexPiece> door_areas_;
};

// The direction that separates two convex counter-clockwise shapes best and the gap along it; negative when they
// overlap: then its amount is the penetration depth.
struct Separation {
  // From the first shape to the second.
  Vec2<double> direction;
  double gap_m = 0;
};
Separation Separate(const Box<double>& a, const Box<double>& b);

// By how much an object is in the way, and of what.
struct Violation {
  int object = -1;
  // The other object, or -1 for the room: outside the floor, or in a door's way when `at_door`.
  int other = -1;
  bool at_door = false;
  double depth_m = 0;
};

// All violations deeper than `tolerance_m` among the solid objects of `objects`.
std::vector<Violation> FindViolations(const Scene& scene, const KeepOut& keep_out, std::span<const int> objects,
                                      const Layout& layout, double tolerance_m);

// The linear inequalities that keep the objects `free` (variables 2k and 2k+1 are the centre of free[k]) apart from
// each other, from the objects `fixed`, inside the floor and out of doors, with `margin_m` to spare. Pairs further
// apart than `reach_m` are left out.
std::vector<LinearInequality> SeparationRows(const Scene& scene, const KeepOut& keep_out, std::span<const int> free,
                                             std::span<const int> fixed, const Layout& layout, double reach_m,
                                             double margin_m);

// Moves the objects `free` as little as needed so that `rows` hold: repeated projection, each on the worst row. Returns
// the largest violation left.
double ProjectOntoRows(std::span<const LinearInequality> rows, std::span<double> x, int max_rounds);

}  // namespace flair::optimizer
