// SPDX-License-Identifier: GPL-3.0-or-later
// Convex shapes whose gaps are measured: the box of a placed object, and fixed areas of the room.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "room/geometry/footprint.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

// A fixed convex area, counter-clockwise, with the outward unit normal of each edge (edge i from vertex i to i + 1).
// `exits[i]` says whether an object may be pushed out over edge i: edges that lie behind a wall are no way out.
struct ConvexPiece {
  std::vector<Vec2<double>> vertices;
  std::vector<Vec2<double>> normals;
  std::vector<char> exits;

  explicit ConvexPiece(const Polygon& polygon) : vertices(polygon.vertices) {
    for (size_t i = 0; i < vertices.size(); ++i) {
      const Segment edge = EdgeAt(polygon, i);
      const double length = edge.length_m();
      normals.push_back(length > 0 ? (-1 / length) * Perpendicular(edge.end - edge.start) : Vec2<double>{0, 0});
      exits.push_back(length > 0);
    }
  }
  // A segment, as a piece without area.
  explicit ConvexPiece(const Segment& segment) : ConvexPiece(Polygon{{segment.start, segment.end}}) {}

  int count() const { return static_cast<int>(vertices.size()); }
  const Vec2<double>& vertex(int i) const { return vertices[static_cast<size_t>(i)]; }
  const Vec2<double>& normal(int i) const { return normals[static_cast<size_t>(i)]; }
  bool exit(int i) const { return exits[static_cast<size_t>(i)] != 0; }
};

// The rectangle of an object at a frame.
template <typename T>
struct Box {
  std::array<Vec2<T>, 4> corners;
  // Of edge i, from corner i to i + 1: back, right, front, left.
  std::array<Vec2<T>, 4> outward;

  Box(const Footprint& footprint, const Frame<T>& frame)
      : corners(Corners(footprint, frame)), outward{-frame.front, frame.right, frame.front, -frame.right} {}
  // The rectangle of depth `depth_m` on one side of the object, outside of it.
  static Box Before(const Footprint& footprint, const Frame<T>& frame, Side side, double depth_m) {
    const Vec2<double> n = LocalNormal(side);
    const double reach = (ExtentBehind(footprint, side) + depth_m) / 2;
    const bool ahead = side == Side::kFront || side == Side::kBack;
    const Footprint strip = ahead ? Footprint{footprint.width_m, depth_m} : Footprint{depth_m, footprint.depth_m};
    Frame<T> moved = frame;
    moved.center = frame.ToRoom(T(reach * n.x), T(reach * n.y));
    return Box(strip, moved);
  }

  static constexpr int count() { return 4; }
  const Vec2<T>& vertex(int i) const { return corners[static_cast<size_t>(i)]; }
  const Vec2<T>& normal(int i) const { return outward[static_cast<size_t>(i)]; }
  static constexpr bool exit(int) { return true; }
};

}  // namespace flair::optimizer
