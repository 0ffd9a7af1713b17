// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/door_area.h"

#include <algorithm>
#include <cmath>

#include "room/geometry/angle.h"

namespace flair {
namespace {

Vec2<double> Turned(const Vec2<double>& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

bool OpensInward(const Opening& door) {
  return door.kind == OpeningKind::kDoor && door.leaf.has_value() && door.leaf->swing == DoorSwing::kInward;
}

// One sector from `first_rad` to `last_rad`, measured from the closed leaf.
Polygon Sector(const Room& room, const Opening& door, double first_rad, double last_rad, int pieces) {
  const Wall& wall = room.walls[static_cast<size_t>(door.wall)];
  const bool from_start = door.leaf->hinge == HingeSide::kStart;
  const Vec2<double> hinge = HingePoint(room, door);
  const Vec2<double> closed = from_start ? wall.Along() : -wall.Along();
  // The room is on the wall's left: a leaf hinged at the start turns counter-clockwise.
  const double sense = from_start ? 1 : -1;
  const double step = (last_rad - first_rad) / pieces;
  // Tangents between the touching points: the polygon contains the arc.
  const double reach = door.width_m / std::cos(step / 2);
  Polygon sector;
  sector.vertices.push_back(hinge);
  sector.vertices.push_back(hinge + door.width_m * Turned(closed, sense * first_rad));
  for (int i = 0; i < pieces; ++i) {
    sector.vertices.push_back(hinge + reach * Turned(closed, sense * (first_rad + (i + 0.5) * step)));
  }
  sector.vertices.push_back(hinge + door.width_m * Turned(closed, sense * last_rad));
  if (sense < 0) std::reverse(sector.vertices.begin(), sector.vertices.end());
  return sector;
}

}  // namespace

Vec2<double> HingePoint(const Room& room, const Opening& door) {
  const Segment opening = room.SegmentOf(door);
  return door.leaf.has_value() && door.leaf->hinge == HingeSide::kEnd ? opening.end : opening.start;
}

Polygon SwingArea(const Room& room, const Opening& door, int arc_pieces) {
  if (!OpensInward(door)) return {};
  return Sector(room, door, 0, door.leaf->swing_angle_rad, arc_pieces);
}

std::vector<Polygon> ConvexSwingAreas(const Room& room, const Opening& door, int arc_pieces) {
  if (!OpensInward(door)) return {};
  const double angle = door.leaf->swing_angle_rad;
  if (angle <= kPi / 2 + 1e-9) return {Sector(room, door, 0, angle, arc_pieces)};
  return {Sector(room, door, 0, angle / 2, arc_pieces), Sector(room, door, angle / 2, angle, arc_pieces)};
}

Polygon PassageArea(const Room& room, const Opening& door, double depth_m, double margin_m) {
  const Wall& wall = room.walls[static_cast<size_t>(door.wall)];
  const Segment opening = room.SegmentOf(door);
  const Vec2<double> a = opening.start - margin_m * wall.Along();
  const Vec2<double> b = opening.end + margin_m * wall.Along();
  const Vec2<double> inward = depth_m * wall.inward_normal;
  return {{a, b, b + inward, a + inward}};
}

}  // namespace flair
