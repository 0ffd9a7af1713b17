// SPDX-License-Identifier: GPL-3.0-or-later
// How well one side of an object meets a wall.
#pragma once

#include <cmath>
#include <span>

#include "room/autodiff/dual.h"
#include "room/geometry/convex_piece.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair::optimizer {

template <typename T>
Vec2<T> MiddleOf(const Footprint& footprint, const Frame<T>& frame, Side side) {
  const Vec2<double> n = LocalNormal(side);
  const double reach = ExtentBehind(footprint, side) / 2;
  return frame.ToRoom(T(reach * n.x), T(reach * n.y));
}

// Outward unit normal of a side.
template <typename T>
Vec2<T> NormalOf(const Frame<T>& frame, Side side) {
  switch (side) {
    case Side::kFront:
      return frame.front;
    case Side::kBack:
      return -frame.front;
    case Side::kLeft:
      return -frame.right;
    case Side::kRight:
      return frame.right;
  }
  return frame.front;
}

// 0 when a side looks straight at a wall, 2 when it looks away: 1 + n_side . n_wall.
template <typename T>
T TurnToWall(const Frame<T>& frame, Side side, const Wall& wall) {
  return T(1.0) + Dot(NormalOf(frame, side), Cast<T>(wall.inward_normal));
}

// How far the side, seen as an interval of its length around its middle, sticks out beyond the wall's ends [m2].
template <typename T>
T SquaredOverhang(const Footprint& footprint, const Vec2<T>& middle, Side side, const Wall& wall) {
  const double length = SideLength(footprint, side);
  const double excess = length - wall.length_m;
  const T offset = wall.Offset(middle);
  // A side longer than the wall sticks out at both ends wherever it is; least when it is centred.
  if (excess > 0) return Square(offset - T(wall.length_m / 2)) + T(excess * excess / 4);
  return SquaredOutside(offset, length / 2, wall.length_m - length / 2);
}

// 0 exactly when the whole side lies on the wall: gap^2 + (1 - cos of the angle) + overhang^2 [m2, radians as metres].
template <typename T>
T SideOnWall(const Footprint& footprint, const Frame<T>& frame, Side side, const Wall& wall) {
  const Vec2<T> middle = MiddleOf(footprint, frame, side);
  return Square(wall.Height(middle)) + TurnToWall(frame, side, wall) + SquaredOverhang(footprint, middle, side, wall);
}

// The side of an object that looks at a wall most directly.
inline Side SideTowards(const Vec2<double>& front, const Wall& wall) {
  const double ahead = Dot(front, wall.inward_normal);
  const double aside = Dot(Vec2<double>{front.y, -front.x}, wall.inward_normal);
  if (std::abs(ahead) >= std::abs(aside)) return ahead > 0 ? Side::kBack : Side::kFront;
  return aside > 0 ? Side::kLeft : Side::kRight;
}

// The walls that a constraint may use: those that were named, or all.
inline std::vector<Wall> WallsToUse(const Room& room, const std::vector<int>& named) {
  if (named.empty()) return room.walls;
  std::vector<Wall> walls;
  for (const int wall : named) walls.push_back(room.walls[static_cast<size_t>(wall)]);
  return walls;
}

// How far something is outside of where it belongs: a rectangle beyond its carrier, a point beyond its zone.

// Sum over the corners of `object` of the squared distances beyond the sides of `carrier`, in the carrier's frame [m2].
template <typename T>
T SquaredSticksOut(const Footprint& object, const Frame<T>& frame, const Footprint& carrier,
                   const Frame<T>& carrier_frame) {
  const Box<T> box(object, frame);
  const Frame<double> carrier_value = ValueOf(carrier_frame);
  T sum(0.0);
  for (int i = 0; i < box.count(); ++i) {
    const Vec2<double> value = carrier_value.ToObject(box.value(i));
    const double w = carrier.width_m / 2, d = carrier.depth_m / 2;
    if (std::abs(value.x) <= w && std::abs(value.y) <= d) continue;
    const Vec2<T> p = carrier_frame.ToObject(box.vertex(i));
    sum += SquaredOutside(p.x, -w, w) + SquaredOutside(p.y, -d, d);
  }
  return sum;
}

// Callers give a zone in which nothing stands yet a middle at least this far away; nothing can be in it.
inline constexpr double kNoPlace_m = 1e5;
inline bool HasPlace(const Vec2<double>& center) { return std::abs(center.x) < kNoPlace_m; }

// How far a point is on the wrong side of the borders between zones.
//   sum over other zones j of max(|p - z_own| - |p - z_j|, 0)^2                                    [m2]
// [Paper] Eq. zone, as released (without its weight). Zero exactly in the own Voronoi cell.
template <typename T>
T SquaredBeyondBorders(const Vec2<T>& p, std::span<const Vec2<double>> centers, int own) {
  const T own_distance = Length(p - Cast<T>(centers[static_cast<size_t>(own)]));
  T sum(0.0);
  for (size_t j = 0; j < centers.size(); ++j) {
    if (static_cast<int>(j) != own) sum += SquaredHinge(own_distance - Length(p - Cast<T>(centers[j])));
  }
  return sum;
}

}  // namespace flair::optimizer
