// SPDX-License-Identifier: GPL-3.0-or-later
// How far something is outside of where it belongs: a rectangle beyond its carrier, a point beyond its zone.
#pragma once

#include <cmath>
#include <span>

#include "room/autodiff/smooth.h"
#include "room/geometry/convex_piece.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

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
