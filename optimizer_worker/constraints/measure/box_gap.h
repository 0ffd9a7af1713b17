// SPDX-License-Identifier: GPL-3.0-or-later
// measure/gap.h for two boxes, in each other's frame: four axes instead of eight edges, and of every edge and vertex
// only the one that can decide. Same witnesses as the general functions, of which these are overloads.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimizer_worker/constraints/measure/convex_piece.h"
#include "optimizer_worker/constraints/measure/witness.h"

namespace flair::optimizer {

// The corner of `box` that is lowest along the direction (across, ahead) in the box's frame; of equals the first.
inline int LowestCorner(double across, double ahead) {
  const bool front = ahead < 0;
  const bool right = across < 0 || (across == 0 && front);
  return front ? (right ? 2 : 3) : (right ? 1 : 0);
}

// Widest separation along the edge normals of `a`.
template <typename T, typename U>
void WidestEdge(const Box<T>& a, const Box<U>& b, Witness::Kind kind, Witness& best) {
  const Vec2<double> d = b.value_center() - a.value_center();
  const auto consider = [&](const Vec2<double>& axis, double half, int edge_along, int edge_against) {
    const double place = Dot(d, axis);
    const double across = Dot(b.value_right(), axis), ahead = Dot(b.value_front(), axis);
    const double gap = std::abs(place) - half - std::abs(across) * b.half_width() - std::abs(ahead) * b.half_depth();
    if (!(gap > best.gap_m)) return;
    const bool along = place > 0;
    const int edge = along ? edge_along : edge_against;
    const int vertex = along ? LowestCorner(across, ahead) : LowestCorner(-across, -ahead);
    best = kind == Witness::kEdgeOfFirst ? Witness{kind, edge, vertex, gap} : Witness{kind, vertex, edge, gap};
  };
  consider(a.value_front(), a.half_depth(), 2, 0);
  consider(a.value_right(), a.half_width(), 1, 3);
}

// Whether all of `b` is beyond one of the edges of `a`.
template <typename T, typename U>
bool BeyondAnEdge(const Box<T>& a, const Box<U>& b) {
  const Vec2<double> d = b.value_center() - a.value_center();
  const auto beyond = [&](const Vec2<double>& axis, double half) {
    return std::abs(Dot(d, axis)) >= half + std::abs(Dot(b.value_right(), axis)) * b.half_width() +
                                         std::abs(Dot(b.value_front(), axis)) * b.half_depth();
  };
  return beyond(a.value_front(), a.half_depth()) || beyond(a.value_right(), a.half_width());
}

// The corner of `b` nearest to `a`, when it is nearer than `least2`; the two are apart.
template <typename T, typename U>
void NearestCorner(const Box<T>& a, const Box<U>& b, Witness::Kind kind, double& least2, Witness& nearest) {
  for (int j = 0; j < 4; ++j) {
    const Vec2<double> d = b.value(j) - a.value_center();
    const double x = Dot(d, a.value_right()), y = Dot(d, a.value_front());
    const double beside = std::max(std::abs(x) - a.half_width(), 0.0);
    const double before = std::max(std::abs(y) - a.half_depth(), 0.0);
    const double distance2 = beside * beside + before * before;
    if (distance2 >= least2) continue;
    least2 = distance2;
    const bool at_corner = beside > 0 && before > 0;
    const int own = at_corner ? LowestCorner(-x, -y) : before > 0 ? (y > 0 ? 2 : 0) : (x > 0 ? 1 : 3);
    const Witness::Kind found = at_corner ? Witness::kVertices : kind;
    nearest = kind == Witness::kEdgeOfFirst ? Witness{found, own, j, 0} : Witness{found, j, own, 0};
  }
}

// Nearest pair of boxes that are known to be apart.
template <typename T, typename U>
Witness NearestFeatures(const Box<T>& a, const Box<U>& b, const Witness& axis) {
  double least2 = std::numeric_limits<double>::infinity();
  Witness nearest = axis;
  NearestCorner(a, b, Witness::kEdgeOfFirst, least2, nearest);
  NearestCorner(b, a, Witness::kEdgeOfSecond, least2, nearest);
  nearest.gap_m = std::sqrt(least2);
  return nearest;
}

}  // namespace flair::optimizer
