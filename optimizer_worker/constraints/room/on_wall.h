// SPDX-License-Identifier: GPL-3.0-or-later
// Hangs a wall object on a wall, off the openings.
//   cost = min over walls of ( gap^2 + (1 - cos a) + overhang^2 + sum over openings of overlap^2 )   [m2]
//   gap, a, overhang  as in wall/against_wall.cc, for the back
//   overlap           shortest slide along the wall that takes the object off a door or window, when their heights meet
// Zero exactly when the back is flush on one wall and off its openings. The paper's Eq. on_wall is a product over all
// walls with headings that are not reduced, so that a painting flush on the south wall at 2 pi costs millions
// (SEMANTICS.md section 5): here the least wall counts.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "optimizer_worker/constraints/measure/walls.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/footprint.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// A wall with the parts of it that an object cannot hang on.
struct HangingWall {
  Wall wall;
  struct Interval {
    double start_m, end_m;
  };
  std::vector<Interval> blocked;
};

// For an object from `bottom_m` to `top_m` above the floor.
std::vector<HangingWall> HangingWalls(const Room& room, double bottom_m, double top_m);

// The cost on one of them.
template <typename T>
T HangsOn(const Footprint& footprint, const Frame<T>& frame, const HangingWall& place) {
  T sum = SideOnWall(footprint, frame, Side::kBack, place.wall);
  const T offset = place.wall.Offset(frame.center);
  for (const HangingWall::Interval& b : place.blocked) {
    const T from_left = offset + T(footprint.width_m / 2 - b.start_m);
    const T from_right = T(b.end_m + footprint.width_m / 2) - offset;
    sum += SquaredHinge(from_left < from_right ? from_left : from_right);
  }
  return sum;
}

// How an object misses hanging on any wall.
Shortfall NotHanging(const PlacedCall& call, int object);
// How `object` misses hanging beside `target`: metres along the wall from its middle to the interval that the target
// covers (to the middle of it when most_along_m is 0), and how far the target stands from that wall.
std::vector<Shortfall> OffBeside(const PlacedCall& call, double most_along_m, double most_away_m, const char* place);

struct OnWallFormula {
  static constexpr int kObjects = 1;
  static constexpr bool kSeesZero = true;
  Footprint footprint;
  std::vector<HangingWall> places;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
