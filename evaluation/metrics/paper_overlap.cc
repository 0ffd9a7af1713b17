// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/paper_overlap.h"

#include <array>
#include <vector>

#include "room/geometry/footprint.h"
#include "room/geometry/polygon.h"

namespace flair::evaluation {
namespace {

constexpr double kDoorMargin_m = 0.2;

std::array<Vec2<double>, 4> DoorSquare(const Room& room, const Opening& door) {
  const Wall& wall = room.walls[static_cast<size_t>(door.wall)];
  const Vec2<double> low = wall.PointAt(door.offset_m - kDoorMargin_m);
  const Vec2<double> high = wall.PointAt(door.offset_m + door.width_m + kDoorMargin_m);
  const bool north = wall.inward_normal.y < -0.5;
  const Vec2<double> behind = (north ? 0 : -kDoorMargin_m) * wall.inward_normal;
  const Vec2<double> inside = (door.width_m + kDoorMargin_m) * wall.inward_normal;
  return {low + behind, high + behind, high + inside, low + inside};
}

}  // namespace

double OorPaperPercent(const LayoutView& view) {
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
