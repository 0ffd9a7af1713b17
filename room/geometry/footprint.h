// SPDX-License-Identifier: GPL-3.0-or-later
// The rectangle that an object covers seen from above, its corners and sides.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "room/geometry/pose.h"
#include "room/geometry/vec2.h"

namespace flair {

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
  switch (side) {
    case Side::kFront:
      return {0, 1};
    case Side::kBack:
      return {0, -1};
    case Side::kLeft:
      return {-1, 0};
    case Side::kRight:
      return {1, 0};
  }
  return {0, 1};
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
