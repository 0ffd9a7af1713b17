// SPDX-License-Identifier: GPL-3.0-or-later
// Segments, and simple polygons in the plane: counter-clockwise, no repeated last vertex. Metres.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "room/geometry/pose.h"

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

// The rectangle that an object covers seen from above, its corners and sides.

struct Footprint {
  // Along the back.
  double width_m = 0;
  // From back to front.
  double depth_m = 0;

  double area_m2() const { return width_m * depth_m; }
  friend bool operator==(const Footprint&, const Footprint&) = default;
};

// From its centre to its corners.
inline double CircumscribedRadius(const Footprint& footprint) {
  return std::sqrt(footprint.width_m * footprint.width_m + footprint.depth_m * footprint.depth_m) / 2;
}

enum class Side { kFront, kBack, kLeft, kRight };
inline constexpr std::array<Side, 4> kSides = {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

enum class Corner { kBackLeft, kBackRight, kFrontRight, kFrontLeft };

std::string_view SideName(Side side);
std::optional<Side> SideFromName(std::string_view name);
std::string_view CornerName(Corner corner);
std::optional<Corner> CornerFromName(std::string_view name);

// In order back-left, back-right, front-right, front-left: counter-clockwise.
template <typename T>
std::array<Vec2<T>, 4> Corners(const Footprint& footprint, const Frame<T>& frame) {
  const T w = T(footprint.width_m / 2);
  const T d = T(footprint.depth_m / 2);
  const Vec2<T> r{w * frame.right.x, w * frame.right.y};
  const Vec2<T> f{d * frame.front.x, d * frame.front.y};
  const Vec2<T>& c = frame.center;
  return {c - r - f, c + r - f, c + r + f, c - r + f};
}

template <typename T>
std::array<Vec2<T>, 4> Corners(const Footprint& footprint, const Pose<T>& pose) {
  return Corners(footprint, FrameOf(pose));
}

// One side of a rectangle in room frame; the normal points out of the object.
template <typename T>
struct SideEdge {
  Vec2<T> first;
  Vec2<T> second;
  Vec2<T> outward_normal;

  Vec2<T> Middle() const { return T(0.5) * (first + second); }
};

// Length of that side.
inline double SideLength(const Footprint& footprint, Side side) {
  return side == Side::kFront || side == Side::kBack ? footprint.width_m : footprint.depth_m;
}

// Extent of the object square to that side.
inline double ExtentBehind(const Footprint& footprint, Side side) {
  return side == Side::kFront || side == Side::kBack ? footprint.depth_m : footprint.width_m;
}

// Outward normal of a side in the object's own frame.
inline Vec2<double> LocalNormal(Side side) {
  constexpr Vec2<double> kNormals[] = {{0, 1}, {0, -1}, {-1, 0}, {1, 0}};
  return kNormals[static_cast<size_t>(side)];
}

template <typename T>
SideEdge<T> EdgeOf(const Footprint& footprint, const Frame<T>& frame, Side side) {
  const std::array<Vec2<T>, 4> c = Corners(footprint, frame);
  switch (side) {
    case Side::kFront:
      return {c[3], c[2], frame.front};
    case Side::kBack:
      return {c[0], c[1], -frame.front};
    case Side::kLeft:
      return {c[0], c[3], -frame.right};
    case Side::kRight:
      return {c[1], c[2], frame.right};
  }
  return {c[3], c[2], frame.front};
}

template <typename T>
SideEdge<T> EdgeOf(const Footprint& footprint, const Pose<T>& pose, Side side) {
  return EdgeOf(footprint, FrameOf(pose), side);
}

}  // namespace flair
