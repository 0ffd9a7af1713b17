// SPDX-License-Identifier: GPL-3.0-or-later
// How far a point is on the wrong side of the borders between zones.
//   sum over other zones j of max(|p - z_own| - |p - z_j|, 0)^2                                    [m2]
// [Paper] Eq. zone, as released (without its weight). Zero exactly in the own Voronoi cell.
#pragma once

#include <cmath>
#include <span>

#include "optimizer_worker/autodiff/smooth.h"

namespace flair::optimizer {

// Callers give a zone in which nothing stands yet a middle at least this far away; nothing can be in it.
inline constexpr double kNoPlace_m = 1e5;
inline bool HasPlace(const Vec2<double>& center) { return std::abs(center.x) < kNoPlace_m; }

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
