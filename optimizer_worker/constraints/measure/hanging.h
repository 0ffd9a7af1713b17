// SPDX-License-Identifier: GPL-3.0-or-later
// Where an object is as seen from a wall, and where on a wall something can hang.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "optimizer_worker/constraints/measure/walls.h"
#include "room/autodiff/dual.h"
#include "room/geometry/polygon.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

// How far an object reaches from its centre along a direction of unit length.
template <typename T>
T Reach(const Footprint& footprint, const Frame<T>& frame, const Vec2<double>& direction) {
  const Vec2<T> d = Cast<T>(direction);
  return (footprint.width_m / 2) * Magnitude(Dot(frame.right, d)) +
         (footprint.depth_m / 2) * Magnitude(Dot(frame.front, d));
}

// How far its nearest corner is from a wall.
template <typename T>
T DistanceFrom(const Footprint& footprint, const Frame<T>& frame, const Wall& wall) {
  return wall.Height(frame.center) - Reach(footprint, frame, wall.inward_normal);
}

// The interval that an object covers along a wall, and how far its nearest corner is from the wall.
template <typename T>
struct WallView {
  T low;
  T high;
  T distance;

  WallView(const Footprint& footprint, const Frame<T>& frame, const Wall& wall)
      : distance(DistanceFrom(footprint, frame, wall)) {
    const T middle = wall.Offset(frame.center), reach = Reach(footprint, frame, wall.Along());
    low = middle - reach;
    high = middle + reach;
  }
  T Middle() const { return 0.5 * (low + high); }
  T Length() const { return high - low; }
};

// A wall with the parts of it that an object cannot hang on.
struct HangingWall {
  Wall wall;
  struct Interval {
    double start_m, end_m;
  };
  std::vector<Interval> blocked;
};

// Blocks what a door's leaf sweeps of the strip before a wall that something `depth_m` deep takes up.
inline void BlockSwept(const Polygon& swept, double depth_m, HangingWall& place) {
  const Wall& wall = place.wall;
  const Vec2<double> inward = depth_m * wall.inward_normal;
  const Polygon strip{{wall.start, wall.end, wall.end + inward, wall.start + inward}};
  const Polygon hit = ClipByConvex(strip, swept.vertices);
  constexpr double kNothing_m2 = 1e-9;
  if (std::abs(SignedArea(hit.vertices)) <= kNothing_m2) return;
  HangingWall::Interval interval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec2<double>& p : hit.vertices) {
    interval.start_m = std::min(interval.start_m, wall.Offset(p));
    interval.end_m = std::max(interval.end_m, wall.Offset(p));
  }
  place.blocked.push_back(interval);
}

// All walls, with what is blocked at the heights of that object: doors and windows, and where a door's leaf comes to.
inline std::vector<HangingWall> HangingWalls(const Scene& scene, int object) {
  std::vector<HangingWall> places;
  for (const Wall& wall : scene.room.walls) places.push_back({wall, {}});
  const bool at_window = scene.objects[static_cast<size_t>(object)].at_window;
  for (const Opening& opening : scene.room.openings) {
    if (at_window && opening.kind == OpeningKind::kWindow) continue;
    if (opening.sill_height_m >= scene.TopOf(object) || opening.head_height_m <= scene.BottomOf(object)) continue;
    places[static_cast<size_t>(opening.wall)].blocked.push_back({opening.offset_m, opening.offset_m + opening.width_m});
    for (const Polygon& swept : ConvexSwingAreas(scene.room, opening)) {
      for (HangingWall& place : places) {
        BlockSwept(swept, scene.objects[static_cast<size_t>(object)].footprint.depth_m, place);
      }
    }
  }
  return places;
}

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

// The wall that a floor object is nearest to, among those that it is beside.
struct NearestWall {
  const Wall* wall = nullptr;
  double distance_m = std::numeric_limits<double>::infinity();
};

// What counts as the same distance from two walls.
inline constexpr double kSameDistance_m = 0.02;

// How much more than 45 degrees the back of a seat looks away from a wall, as 1 - cos: what hangs there is not above
// it.
template <typename T>
T TurnedFrom(const Frame<T>& seat, const Wall& wall) {
  return Positive(TurnToWall(seat, Side::kBack, wall) - (1 - std::sqrt(0.5)));
}

// `is_seat`: only of those behind it.
inline NearestWall NearestWallTo(const Footprint& footprint, const Frame<double>& frame,
                                 const std::vector<HangingWall>& places, bool is_seat = false) {
  NearestWall nearest;
  for (const auto& [wall, blocked] : places) {
    if (is_seat && TurnedFrom(frame, wall) > 0) continue;
    // A wall that runs elsewhere is not a neighbour.
    const double offset = wall.Offset(frame.center);
    if (offset < 0 || offset > wall.length_m) continue;
    const double distance_m = DistanceFrom(footprint, frame, wall);
    if (distance_m < nearest.distance_m && distance_m > -kSameDistance_m) nearest = {&wall, distance_m};
  }
  return nearest;
}

// How far a floor object at `distance_m` from a wall is from being at it:
//   max(distance - max(least distance to any wall, near_m), 0)^2 [m2],
// so that its nearest wall and every one within near_m count as its own.
template <typename T>
T SquaredNotItsWall(const Footprint& footprint, const Frame<T>& frame, const T& distance_m, const NearestWall& nearest,
                    double near_m) {
  const double own_m = ValueOf(distance_m);
  if (own_m <= std::max(std::min(nearest.distance_m, own_m), near_m) + kSameDistance_m) return T(0.0);
  const T excess = distance_m - kSameDistance_m;
  if (nearest.distance_m <= near_m) return Square(excess - near_m);
  return Square(excess - DistanceFrom(footprint, frame, *nearest.wall));
}

}  // namespace flair::optimizer
