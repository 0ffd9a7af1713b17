// SPDX-License-Identifier: GPL-3.0-or-later
// Where an object is as seen from a wall.
#pragma once

#include <limits>
#include <vector>

#include "optimizer_worker/autodiff/smooth.h"
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
    const std::array<Vec2<T>, 4> corners = Corners(footprint, frame);
    low = high = wall.Offset(corners[0]);
    distance = wall.Height(corners[0]);
    for (size_t i = 1; i < corners.size(); ++i) {
      const T offset = wall.Offset(corners[i]);
      const T height = wall.Height(corners[i]);
      if (offset < low) low = offset;
      if (offset > high) high = offset;
      if (height < distance) distance = height;
    }
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
  T least(near_m);
  double least_value = std::numeric_limits<double>::infinity();
  for (const HangingWall& other : places) {
    const Vec2<T>& center = frame.center;
    // A wall that runs elsewhere is not a neighbour.
    if (ValueOf(other.wall.Offset(center)) < 0 || ValueOf(other.wall.Offset(center)) > other.wall.length_m) continue;
    const T distance = WallView<T>(footprint, frame, other.wall).distance;
    if (ValueOf(distance) < least_value && ValueOf(distance) > -kSame_m) {
      least_value = ValueOf(distance);
      least = least_value > near_m ? distance : T(near_m);
    }
  }
  return SquaredHinge(WallView<T>(footprint, frame, place.wall).distance - least - kSame_m);
}

}  // namespace flair::optimizer
