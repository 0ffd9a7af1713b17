// SPDX-License-Identifier: GPL-3.0-or-later
// Convex shapes whose gaps are measured: the box of a placed object, and fixed areas of the room.
#pragma once

#include <array>
#include <vector>

#include "room/autodiff/dual.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair {

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
  const Vec2<double>& value(int i) const { return vertex(i); }
  const Vec2<double>& value_normal(int i) const { return normal(i); }
  bool exit(int i) const { return exits[static_cast<size_t>(i)] != 0; }
};

// The rectangle of an object at a frame. Corners are worked out with derivatives only when they are asked for: of a gap
// one or two decide.
template <typename T>
class Box {
 public:
  Box(const Footprint& footprint, const Frame<T>& frame)
      : half_width_(footprint.width_m / 2), half_depth_(footprint.depth_m / 2), frame_(frame) {
    const Frame<double> value = ValueOf(frame);
    values_ = Corners(footprint, value);
    value_normals_ = {-value.front, value.right, value.front, -value.right};
  }
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

  double half_width() const { return half_width_; }
  double half_depth() const { return half_depth_; }
  Vec2<double> value_center() const { return ValueOf(frame_.center); }
  Vec2<double> value_right() const { return value_normals_[1]; }
  Vec2<double> value_front() const { return value_normals_[2]; }
  static constexpr int count() { return 4; }
  static constexpr bool exit(int) { return true; }
  // Back-left, back-right, front-right, front-left.
  const Vec2<double>& value(int i) const { return values_[static_cast<size_t>(i)]; }
  // Of edge i, from corner i to i + 1: back, right, front, left.
  const Vec2<double>& value_normal(int i) const { return value_normals_[static_cast<size_t>(i)]; }
  Vec2<T> vertex(int i) const {
    const double u = i == 0 || i == 3 ? -half_width_ : half_width_;
    const double v = i < 2 ? -half_depth_ : half_depth_;
    return {frame_.center.x + u * frame_.right.x + v * frame_.front.x,
            frame_.center.y + u * frame_.right.y + v * frame_.front.y};
  }
  Vec2<T> normal(int i) const {
    switch (i) {
      case 0:
        return -frame_.front;
      case 1:
        return frame_.right;
      case 2:
        return frame_.front;
      default:
        return -frame_.right;
    }
  }

 private:
  double half_width_;
  double half_depth_;
  Frame<T> frame_;
  std::array<Vec2<double>, 4> values_;
  std::array<Vec2<double>, 4> value_normals_;
};

}  // namespace flair
