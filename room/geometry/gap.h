// SPDX-License-Identifier: GPL-3.0-or-later
// The signed gap between two convex shapes:
//   gap(A, B) = Euclidean distance of A and B when they are apart            (> 0) [m]
//             = -(length of the shortest translation that parts them)        (<= 0) [m]
// Overlap by separating axes: over the edge normals n of either shape, gap_n = min_{q in other} n.(q - p), p on the
// edge; the largest gap_n is minus the penetration depth. Apart, the nearest points are an edge and a vertex (again
// gap_n) or two vertices. The deciding pair ("witness") is found on the values; only it is differentiated. Continuous
// everywhere, differentiable but where the witness changes. Two boxes, the common case, have faster ways to find it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "room/autodiff/dual.h"
#include "room/geometry/convex_piece.h"

namespace flair {

// What decides a gap between two shapes: edge `edge` of one against vertex `vertex` of the other, or two vertices.
struct Witness {
  enum Kind { kEdgeOfFirst, kEdgeOfSecond, kVertices } kind = kEdgeOfFirst;
  // Index of an edge or a vertex of the first and of the second shape.
  int first = 0;
  int second = 0;
  double gap_m = 0;
};

// Two boxes, in each other's frame: four axes instead of eight edges, and of every edge and vertex
// only the one that can decide. Same witnesses as the general functions, of which these are overloads.

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

// Widest separation along edge normals of `a`; `vertex` is the vertex of `b` that is nearest to that edge.
template <typename A, typename B>
void WidestEdge(const A& a, const B& b, Witness::Kind kind, Witness& best) {
  for (int i = 0; i < a.count(); ++i) {
    if (!a.exit(i)) continue;
    const Vec2<double>& n = a.value_normal(i);
    const Vec2<double>& p = a.value(i);
    double nearest = std::numeric_limits<double>::infinity();
    int vertex = 0;
    for (int j = 0; j < b.count(); ++j) {
      const Vec2<double>& q = b.value(j);
      const double height = n.x * (q.x - p.x) + n.y * (q.y - p.y);
      if (height < nearest) nearest = height, vertex = j;
    }
    if (nearest > best.gap_m)
      best = kind == Witness::kEdgeOfFirst ? Witness{kind, i, vertex, nearest} : Witness{kind, vertex, i, nearest};
  }
}

// Deciding edge and vertex by separating axes; exact when they overlap, a lower bound of the distance when apart.
template <typename A, typename B>
Witness SeparatingAxis(const A& a, const B& b) {
  Witness best;
  best.gap_m = -std::numeric_limits<double>::infinity();
  WidestEdge(a, b, Witness::kEdgeOfFirst, best);
  WidestEdge(b, a, Witness::kEdgeOfSecond, best);
  return best;
}

// Nearest pair of shapes that are known to be apart.
template <typename A, typename B>
Witness NearestFeatures(const A& a, const B& b, const Witness& axis) {
  // An edge this short is a point; its direction is rounding.
  constexpr double kPoint_m2 = 1e-18;
  double least2 = std::numeric_limits<double>::infinity();
  Witness nearest = axis;
  const auto consider_edges = [&least2, &nearest](const auto& edges, const auto& points, Witness::Kind kind) {
    for (int i = 0; i < edges.count(); ++i) {
      const Vec2<double>& p = edges.value(i);
      const Vec2<double>& q = edges.value((i + 1) % edges.count());
      const Vec2<double> d = q - p;
      const double length2 = SquaredNorm(d);
      for (int j = 0; j < points.count(); ++j) {
        const Vec2<double> r = points.value(j) - p;
        const double along = Dot(r, d);
        Witness w;
        double distance2 = 0;
        if (along > 0 && along < length2 && length2 > kPoint_m2) {
          const double cross = Cross(d, r);
          // Seen from behind: the shape's other side is nearer. Matters for shapes without depth.
          if (cross > 0) continue;
          distance2 = cross * cross / length2;
          w = kind == Witness::kEdgeOfFirst ? Witness{kind, i, j, 0} : Witness{kind, j, i, 0};
        } else {
          const int end = along <= 0 ? i : (i + 1) % edges.count();
          distance2 = along <= 0 ? SquaredNorm(r) : SquaredNorm(r - d);
          w = kind == Witness::kEdgeOfFirst ? Witness{Witness::kVertices, end, j, 0}
                                            : Witness{Witness::kVertices, j, end, 0};
        }
        if (distance2 < least2) least2 = distance2, nearest = w;
      }
    }
  };
  consider_edges(a, b, Witness::kEdgeOfFirst);
  consider_edges(b, a, Witness::kEdgeOfSecond);
  nearest.gap_m = std::sqrt(least2);
  return nearest;
}

// The gap along a witness, with derivatives.
template <typename T, typename A, typename B>
T Along(const A& a, const B& b, const Witness& w) {
  const Vec2<T> p = Cast<T>(a.vertex(w.first));
  const Vec2<T> q = Cast<T>(b.vertex(w.second));
  switch (w.kind) {
    case Witness::kEdgeOfFirst:
      return Dot(Cast<T>(a.normal(w.first)), q - p);
    case Witness::kEdgeOfSecond:
      return Dot(Cast<T>(b.normal(w.second)), p - q);
    case Witness::kVertices:
      return Length(q - p);
  }
  return T(0.0);
}

// The deciding pair, from the separating axis.
template <typename A, typename B>
Witness Deciding(const A& a, const B& b, const Witness& axis) {
  // Closer than this the axis is exact enough, and it has a slope at contact where a distance has none.
  constexpr double kContact_m = 1e-9;
  return axis.gap_m <= kContact_m ? axis : NearestFeatures(a, b, axis);
}

template <typename T, typename A, typename B>
T Gap(const A& a, const B& b) {
  return Along<T>(a, b, Deciding(a, b, SeparatingAxis(a, b)));
}

// max(least_m - gap, 0)^2 [m2], for least_m >= 0: zero when they are that far apart. Cheaper than Gap.
template <typename T, typename A, typename B>
T SquaredNearness(const A& a, const B& b, double least_m) {
  const Witness axis = SeparatingAxis(a, b);
  // The gap is at least that of any axis.
  if (axis.gap_m >= least_m) return T(0.0);
  const Witness deciding = Deciding(a, b, axis);
  if (deciding.gap_m >= least_m) return T(0.0);
  return SquaredHinge(least_m - Along<T>(a, b, deciding));
}

// max(gap - most_m, 0)^2 [m2], for most_m >= 0: zero when they are that close.
template <typename T, typename A, typename B>
T SquaredDistanceBeyond(const A& a, const B& b, double most_m) {
  const Witness deciding = Deciding(a, b, SeparatingAxis(a, b));
  if (deciding.gap_m <= most_m) return T(0.0);
  return SquaredHinge(Along<T>(a, b, deciding) - most_m);
}

// Whether all of `b` is beyond one of the edges of `a`.
template <typename A, typename B>
bool BeyondAnEdge(const A& a, const B& b) {
  for (int i = 0; i < a.count(); ++i) {
    if (!a.exit(i)) continue;
    const Vec2<double>& n = a.value_normal(i);
    const double edge = Dot(n, a.value(i));
    bool beyond = true;
    for (int j = 0; beyond && j < b.count(); ++j) beyond = Dot(n, b.value(j)) >= edge;
    if (beyond) return true;
  }
  return false;
}

// max(-gap, 0)^2 [m2]: zero when apart, squared penetration depth else. Cheaper than Gap.
template <typename T, typename A, typename B>
T SquaredPenetration(const A& a, const B& b) {
  // Most are apart, and one edge that shows it is enough.
  if (BeyondAnEdge(a, b) || BeyondAnEdge(b, a)) return T(0.0);
  const Witness axis = SeparatingAxis(a, b);
  if (axis.gap_m >= 0) return T(0.0);
  return Square(Along<T>(a, b, axis));
}

}  // namespace flair
