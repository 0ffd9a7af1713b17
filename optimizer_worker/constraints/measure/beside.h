// SPDX-License-Identifier: GPL-3.0-or-later
// Where an object is as seen from a wall.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/room/on_wall.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

// The interval that an object covers along a wall, and how far its nearest corner is from the wall.
template <typename T>
struct WallView {
  T low;
  T high;
  T distance;

  WallView(const Footprint& footprint, const Frame<T>& frame, const Wall& wall) {
    const Box<T> box(footprint, frame);
    int lowest = 0, highest = 0, nearest = 0;
    for (int i = 1; i < box.count(); ++i) {
      if (wall.Offset(box.value(i)) < wall.Offset(box.value(lowest))) lowest = i;
      if (wall.Offset(box.value(i)) > wall.Offset(box.value(highest))) highest = i;
      if (wall.Height(box.value(i)) < wall.Height(box.value(nearest))) nearest = i;
    }
    low = wall.Offset(box.vertex(lowest));
    high = wall.Offset(box.vertex(highest));
    distance = wall.Height(box.vertex(nearest));
  }
  T Middle() const { return 0.5 * (low + high); }
  T Length() const { return high - low; }
};

// How far a floor object is from being at a wall: max(distance - max(least distance to any wall, near_m), 0)^2, so that
// its nearest wall and every one within near_m count as its own [m2].
template <typename T>
T SquaredNotItsWall(const Footprint& footprint, const Frame<T>& frame, const HangingWall& place,
                    const std::vector<HangingWall>& places, double near_m) {
  constexpr double kSame_m = 0.02;
  const Frame<double> value = ValueOf(frame);
  double least = std::numeric_limits<double>::infinity();
  const Wall* nearest = &place.wall;
  for (const HangingWall& other : places) {
    // A wall that runs elsewhere is not a neighbour.
    const double offset = other.wall.Offset(value.center);
    if (offset < 0 || offset > other.wall.length_m) continue;
    const double distance = WallView<double>(footprint, value, other.wall).distance;
    if (distance < least && distance > -kSame_m) least = distance, nearest = &other.wall;
  }
  const double own = WallView<double>(footprint, value, place.wall).distance;
  if (own <= std::max(std::min(least, own), near_m) + kSame_m) return T(0.0);
  const T excess = WallView<T>(footprint, frame, place.wall).distance - kSame_m;
  if (least <= near_m) return Square(excess - near_m);
  return Square(excess - WallView<T>(footprint, frame, *nearest).distance);
}

}  // namespace flair::optimizer
