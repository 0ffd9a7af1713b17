// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/measure/room_areas.h"

#include <cmath>

namespace flair::optimizer {
namespace {

constexpr double kBehind_m = 10;
constexpr double kOnWall_m = 1e-9;

}  // namespace

ConvexPiece AreaAtWall(const Polygon& area, const Wall& wall) {
  Polygon extended;
  for (size_t i = 0; i < area.vertices.size(); ++i) {
    const auto [p, q] = EdgeAt(area, i);
    extended.vertices.push_back(p);
    if (std::abs(wall.Height(p)) < kOnWall_m && std::abs(wall.Height(q)) < kOnWall_m) {
      extended.vertices.push_back(p - kBehind_m * wall.inward_normal);
      extended.vertices.push_back(q - kBehind_m * wall.inward_normal);
    }
  }
  ConvexPiece piece(extended);
  for (size_t i = 0; i < piece.normals.size(); ++i) {
    if (Dot(piece.normals[i], wall.inward_normal) < -0.5 && wall.Height(piece.vertices[i]) < -kOnWall_m) {
      piece.exits[i] = false;
    }
  }
  return piece;
}

ConvexPiece StripAtWall(const Wall& wall, double start_m, double end_m, double depth_m) {
  const Vec2<double> inward = depth_m * wall.inward_normal;
  const Vec2<double> a = wall.PointAt(start_m), b = wall.PointAt(end_m);
  return AreaAtWall({{a, b, b + inward, a + inward}}, wall);
}

}  // namespace flair::optimizer
