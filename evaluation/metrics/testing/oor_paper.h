// SPDX-License-Identifier: GPL-3.0-or-later
// The released code's measure, by which tests compare with published figures.
#pragma once

#include <array>
#include <vector>

#include "evaluation/metrics/layout_metrics.h"
#include "room/geometry/polygon.h"
#include "room/scene/room.h"

namespace flair::evaluation {

inline constexpr double kDoorMargin_m = 0.2;

inline std::array<Vec2<double>, 4> DoorSquare(const Room& room, const Opening& door) {
  const Wall& wall = room.walls[static_cast<size_t>(door.wall)];
  const Vec2<double> low = wall.PointAt(door.offset_m - kDoorMargin_m);
  const Vec2<double> high = wall.PointAt(door.offset_m + door.width_m + kDoorMargin_m);
  const bool north = wall.inward_normal.y < -0.5;
  const Vec2<double> behind = (north ? 0 : -kDoorMargin_m) * wall.inward_normal;
  const Vec2<double> inside = (door.width_m + kDoorMargin_m) * wall.inward_normal;
  return {low + behind, high + behind, high + inside, low + inside};
}

// [Paper] OOR as the released code has it, to compare with published figures. For floor objects it differs from
// OorPercent in two places only:
//   rugs   floor objects like others here: they overlap everything that stands on them
//   doors  a square here, whatever way the door opens: the leaf's width and 0.2 m more at both ends, into the room, and
//          behind the wall, except behind a wall that the room lies south of; the sector that the leaf sweeps there
// Floor objects against each other and in door zones, percent of the room's area. Without tertiary objects, which the
// released measure cannot take when their type was not recorded.
inline double OorPaperPercent(const LayoutView& view) {
  const Scene& scene = view.scene;
  std::vector<std::array<Vec2<double>, 4>> placed;
  double area = 0;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (!view.Has(i) || scene.objects[i].kind != ObjectKind::kFloor) continue;
    const std::array<Vec2<double>, 4> corners = Corners(scene.objects[i].footprint, view.layout[i]);
    for (const auto& other : placed) area += ConvexIntersectionArea(corners, other);
    for (const Opening& door : scene.room.openings) {
      if (door.kind == OpeningKind::kDoor) area += ConvexIntersectionArea(corners, DoorSquare(scene.room, door));
    }
    placed.push_back(corners);
  }
  return 100 * area / Area(scene.room.floor);
}

}  // namespace flair::evaluation
