// SPDX-License-Identifier: GPL-3.0-or-later
// Segments, and simple polygons in the plane: counter-clockwise, no repeated last vertex. Metres.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "room/geometry/vec2.h"

namespace flair {

struct Segment {
  Vec2<double> start;
  Vec2<double> end;

  double length_m() const { return Distance(start, end); }
  Vec2<double> Middle() const { return {(start.x + end.x) / 2, (start.y + end.y) / 2}; }
};

// The point of the segment nearest to p.
inline Vec2<double> NearestPoint(const Segment& s, const Vec2<double>& p) {
  const Vec2<double> d = s.end - s.start;
  const double length2 = SquaredNorm(d);
  if (length2 == 0) return s.start;
  const double t = std::clamp(Dot(p - s.start, d) / length2, 0.0, 1.0);
  return {s.start.x + t * d.x, s.start.y + t * d.y};
}

inline double DistanceTo(const Segment& s, const Vec2<double>& p) { return Distance(p, NearestPoint(s, p)); }

// Whether the two share a point; touching counts.
bool Intersects(const Segment& a, const Segment& b);

// Least distance between points of the two; 0 when they intersect.
double DistanceBetween(const Segment& a, const Segment& b);

struct Polygon {
  std::vector<Vec2<double>> vertices;

  friend bool operator==(const Polygon&, const Polygon&) = default;
};

struct BoundingBox {
  Vec2<double> min;
  Vec2<double> max;

  double width_m() const { return max.x - min.x; }
  double height_m() const { return max.y - min.y; }
  Vec2<double> Center() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
};

// Positive for counter-clockwise order.
double SignedArea(std::span<const Vec2<double>> vertices);
double Area(const Polygon& polygon);
// Centre of mass; the mean of the vertices when the area is 0.
Vec2<double> Centroid(const Polygon& polygon);
BoundingBox BoundsOf(std::span<const Vec2<double>> points);
BoundingBox BoundsOf(const Polygon& polygon);
// Edge i runs from vertex i to vertex i + 1.
Segment EdgeAt(const Polygon& polygon, size_t i);
// Inside or on the boundary (exactly; no tolerance).
bool Contains(const Polygon& polygon, const Vec2<double>& p);
// At least three vertices, no two edges touch but neighbours in their shared vertex, area not 0.
bool IsSimple(const Polygon& polygon);
bool IsConvex(const Polygon& polygon);
double DistanceToBoundary(const Polygon& polygon, const Vec2<double>& p);
// Distance to the boundary, positive inside, negative outside.
double SignedDistance(const Polygon& polygon, const Vec2<double>& p);

// The part of `subject` (any simple polygon) within the convex, counter-clockwise `clip`. The result of a non-convex
// subject may contain edges that run along the clip's boundary twice; its area is right.
Polygon ClipByConvex(const Polygon& subject, std::span<const Vec2<double>> clip);
// Area shared by two convex counter-clockwise polygons.
double ConvexIntersectionArea(std::span<const Vec2<double>> a, std::span<const Vec2<double>> b);

// The polygon cut into triangles, counter-clockwise (ear clipping). Empty when it is not simple.
std::vector<Polygon> Triangulate(const Polygon& polygon);

}  // namespace flair
