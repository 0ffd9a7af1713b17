// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>

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

// As walls are called that nobody has named: "wall_3".
bool IsNumbered(std::string_view name) {
  return name.starts_with("wall_") && name.size() > 5 && name.find_first_not_of("0123456789", 5) == name.npos;
}

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
  if (sense < 0) std::ranges::reverse(sector.vertices);
  return sector;
}

// The place of the first with that name; -1 when there is none.
template <typename Item>
int IndexIn(const std::vector<Item>& list, std::string Item::*name, std::string_view wanted) {
  const auto found = std::ranges::find(list, wanted, name);
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

}  // namespace

double Wall::BackHeading() const { return WrapHeading(HeadingOf(inward_normal)); }

int Room::WallIndex(std::string_view name) const { return IndexIn(walls, &Wall::name, name); }

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

Vec2<double> HingePoint(const Room& room, const Opening& door) {
  const Segment opening = room.SegmentOf(door);
  return door.leaf.has_value() && door.leaf->hinge == HingeSide::kEnd ? opening.end : opening.start;
}

std::vector<Polygon> ConvexSwingAreas(const Room& room, const Opening& door, int arc_pieces) {
  if (!OpensInward(door)) return {};
  const double angle = door.leaf->swing_angle_rad;
  if (angle <= kPi / 2 + 1e-9) return {Sector(room, door, 0, angle, arc_pieces)};
  return {Sector(room, door, 0, angle / 2, arc_pieces), Sector(room, door, angle / 2, angle, arc_pieces)};
}

std::string WallName(const Room& room, const Wall& wall) {
  if (!IsNumbered(wall.name)) {
    std::string name = wall.name;
    std::ranges::replace(name, '_', ' ');
    return fmt::format("the {}{}", name, name.ends_with("wall") ? "" : " wall");
  }
  const std::string side = CompassName(wall.inward_normal);
  const bool alone =
      std::ranges::count_if(room.walls, [&](const Wall& other) {
        return other.name == side || (IsNumbered(other.name) && CompassName(other.inward_normal) == side);
      }) < 2;
  return alone ? fmt::format("the {} wall", side) : fmt::format("the {:.2f} m {} wall", wall.length_m, side);
}

std::string NameForPeople(const Room& room, const Opening& opening) {
  const char* const kind = opening.kind == OpeningKind::kDoor ? "door" : "window";
  int count = 0, number = 0;
  for (const Opening& other : room.openings) {
    if (other.kind != opening.kind || other.wall != opening.wall) continue;
    ++count;
    if (other.id == opening.id) number = count;
  }
  const std::string wall = WallName(room, room.walls[static_cast<size_t>(opening.wall)]);
  return count > 1 ? fmt::format("{} {} in {}", kind, number, wall) : fmt::format("the {} in {}", kind, wall);
}

Polygon PassageArea(const Room& room, const Opening& door, double depth_m, double margin_m) {
  const Wall& wall = room.walls[static_cast<size_t>(door.wall)];
  const Segment opening = room.SegmentOf(door);
  const Vec2<double> a = opening.start - margin_m * wall.Along();
  const Vec2<double> b = opening.end + margin_m * wall.Along();
  const Vec2<double> inward = depth_m * wall.inward_normal;
  return {{a, b, b + inward, a + inward}};
}

int Scene::IndexOf(std::string_view object_id) const { return IndexIn(objects, &Object::id, object_id); }

int Scene::ZoneIndexOf(std::string_view zone_id) const { return IndexIn(zones, &Zone::id, zone_id); }

bool Scene::Carries(int carrier, int object) const {
  // As below: a circle of hosts ends here.
  for (size_t steps = 0; object >= 0 && steps <= objects.size(); ++steps) {
    if (object == carrier) return true;
    const Object& carried = objects[static_cast<size_t>(object)];
    if (carried.kind == ObjectKind::kFloor || carried.host < 0) return false;
    const ObjectKind by = objects[static_cast<size_t>(carried.host)].kind;
    if (carried.kind != ObjectKind::kSurface && by != carried.kind) return false;
    object = carried.host;
  }
  return false;
}

std::optional<Footprint> OpeningIn(const Object& top) {
  const Footprint opening{top.footprint.width_m - 2 * top.rim_sides_m, top.footprint.depth_m - 2 * top.rim_ends_m};
  const bool open = (top.rim_sides_m > 0 || top.rim_ends_m > 0) && opening.width_m > 0 && opening.depth_m > 0;
  return open ? std::optional(opening) : std::nullopt;
}

double Scene::BottomOf(int object) const {
  double bottom = 0;
  // A chain of hosts is at most as long as the list; anything longer is a circle and ends here.
  for (size_t steps = 0; object >= 0 && steps <= objects.size(); ++steps) {
    const Object& o = objects[static_cast<size_t>(object)];
    bottom += o.elevation_m;
    if (o.kind == ObjectKind::kCeiling && o.elevation_m == 0) return std::max(0.0, room.height_m - o.height_m);
    if (o.kind != ObjectKind::kSurface || o.host < 0) break;
    object = o.host;
    bottom += objects[static_cast<size_t>(object)].height_m;
  }
  return bottom;
}

std::string NameForPeople(const Scene& scene, int object) {
  const Object& what = scene.objects[static_cast<size_t>(object)];
  const std::string name = what.name.empty() ? what.id : what.name;
  const auto likes = [&](const Object& other) { return other.name == what.name; };
  if (std::ranges::count_if(scene.objects, likes) <= 1) return "the " + name;
  // The number of its id when it has one, else its place among its likes.
  const size_t number = what.id.find_last_not_of("0123456789") + 1;
  if (number < what.id.size()) return fmt::format("{} {}", name, what.id.substr(number));
  const auto before = std::count_if(scene.objects.begin(), scene.objects.begin() + object, likes);
  return fmt::format("{} {}", name, before + 1);
}

}  // namespace flair
