// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/room.h"

#include <cmath>

#include "room/geometry/angle.h"

namespace flair {
namespace {

// Four walls along the axes, one facing each way.
bool IsUprightRectangle(const Polygon& floor) {
  if (floor.vertices.size() != 4) return false;
  for (size_t i = 0; i < 4; ++i) {
    const Segment edge = EdgeAt(floor, i);
    if (edge.start.x != edge.end.x && edge.start.y != edge.end.y) return false;
  }
  return true;
}

std::string CompassName(const Vec2<double>& inward_normal) {
  if (inward_normal.y > 0.5) return "south";
  if (inward_normal.y < -0.5) return "north";
  return inward_normal.x > 0.5 ? "west" : "east";
}

}  // namespace

double Wall::BackHeading() const { return WrapHeading(HeadingOf(inward_normal)); }

int Room::WallIndex(std::string_view name) const {
  for (size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Segment Room::SegmentOf(const Opening& opening) const {
  const Wall& wall = walls[static_cast<size_t>(opening.wall)];
  return {wall.PointAt(opening.offset_m), wall.PointAt(opening.offset_m + opening.width_m)};
}

Segment Room::SegmentOf(const Socket& socket) const {
  const Vec2<double> p = walls[static_cast<size_t>(socket.wall)].PointAt(socket.offset_m);
  return {p, p};
}

std::vector<Wall> WallsOf(const Polygon& floor, const std::vector<std::string>& names) {
  std::vector<Wall> walls;
  const bool compass = IsUprightRectangle(floor);
  for (size_t i = 0; i < floor.vertices.size(); ++i) {
    const Segment edge = EdgeAt(floor, i);
    Wall wall;
    wall.start = edge.start;
    wall.end = edge.end;
    wall.length_m = edge.length_m();
    wall.inward_normal = (1 / wall.length_m) * Perpendicular(edge.end - edge.start);
    if (i < names.size()) {
      wall.name = names[i];
    } else {
      wall.name = compass ? CompassName(wall.inward_normal) : "wall_" + std::to_string(i + 1);
    }
    walls.push_back(std::move(wall));
  }
  return walls;
}

Room RectangularRoom(double width_m, double depth_m) {
  Room room;
  room.floor.vertices = {{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}};
  room.walls = WallsOf(room.floor);
  return room;
}

}  // namespace flair
