// SPDX-License-Identifier: GPL-3.0-or-later
// Simple polygons in the plane, counter-clockwise, no repeated last vertex. Metres.
#pragma once

#include <span>
#include <vector>

#include "room/geometry/segment.h"
#include "room/geometry/vec2.h"

namespace flair {

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
