// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/conversion/conversion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "room/geometry/pose.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
namespace {

// What is what in messages; the first stands for what is unknown.
constexpr std::pair<v1::DoorSwing, DoorSwing> kSwings[] = {{v1::DOOR_SWING_INWARD, DoorSwing::kInward},
                                                           {v1::DOOR_SWING_OUTWARD, DoorSwing::kOutward},
                                                           {v1::DOOR_SWING_SLIDING, DoorSwing::kSliding},
                                                           {v1::DOOR_SWING_NONE, DoorSwing::kNone}};
constexpr std::pair<v1::ObjectRole, ObjectRole> kRoles[] = {{v1::OBJECT_ROLE_SECONDARY, ObjectRole::kSecondary},
                                                            {v1::OBJECT_ROLE_PRIMARY, ObjectRole::kPrimary},
                                                            {v1::OBJECT_ROLE_TERTIARY, ObjectRole::kTertiary}};
constexpr std::pair<v1::ObjectKind, ObjectKind> kKinds[] = {{v1::OBJECT_KIND_FLOOR, ObjectKind::kFloor},
                                                            {v1::OBJECT_KIND_WALL, ObjectKind::kWall},
                                                            {v1::OBJECT_KIND_CEILING, ObjectKind::kCeiling},
                                                            {v1::OBJECT_KIND_SURFACE, ObjectKind::kSurface}};

template <typename Proto, typename Value, size_t N>
Value FromProto(const std::pair<Proto, Value> (&pairs)[N], Proto message) {
  const auto found = std::ranges::find(pairs, message, &std::pair<Proto, Value>::first);
  return found == std::end(pairs) ? pairs[0].second : found->second;
}

template <typename Proto, typename Value, size_t N>
Proto ToProto(const std::pair<Proto, Value> (&pairs)[N], Value value) {
  return std::ranges::find(pairs, value, &std::pair<Proto, Value>::second)->first;
}

Opening OpeningFromProto(const v1::Opening& message, const Room& room) {
  Opening opening{.id = message.id(),
                  .kind = message.kind() == v1::OPENING_KIND_DOOR ? OpeningKind::kDoor : OpeningKind::kWindow,
                  .wall = room.WallIndex(message.wall()),
                  .offset_m = message.offset_m(),
                  .width_m = message.width_m(),
                  .sill_height_m = message.sill_height_m(),
                  .head_height_m = message.head_height_m(),
                  .leaf = std::nullopt};
  if (message.has_leaf()) {
    const bool at_end = message.leaf().hinge() == v1::HINGE_SIDE_END;
    opening.leaf = DoorLeaf{.hinge = at_end ? HingeSide::kEnd : HingeSide::kStart,
                            .swing = FromProto(kSwings, message.leaf().swing()),
                            .swing_angle_rad = message.leaf().swing_angle_rad()};
  }
  return opening;
}

void OpeningToProto(const Opening& opening, const Room& room, v1::Opening& message) {
  message.set_id(opening.id);
  message.set_kind(opening.kind == OpeningKind::kDoor ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW);
  message.set_wall(room.walls[static_cast<size_t>(opening.wall)].name);
  message.set_offset_m(opening.offset_m);
  message.set_width_m(opening.width_m);
  message.set_sill_height_m(opening.sill_height_m);
  message.set_head_height_m(opening.head_height_m);
  if (!opening.leaf) return;
  v1::DoorLeaf& leaf = *message.mutable_leaf();
  leaf.set_hinge(opening.leaf->hinge == HingeSide::kEnd ? v1::HINGE_SIDE_END : v1::HINGE_SIDE_START);
  leaf.set_swing(ToProto(kSwings, opening.leaf->swing));
  leaf.set_swing_angle_rad(opening.leaf->swing_angle_rad);
}

Object ObjectFromProto(const v1::Object& message, const Scene& scene) {
  return {.id = message.id(),
          .name = message.name(),
          .role = FromProto(kRoles, message.role()),
          .kind = FromProto(kKinds, message.kind()),
          .zone = scene.ZoneIndexOf(message.zone_id()),
          .footprint = {.width_m = message.width_m(), .depth_m = message.depth_m()},
          .height_m = message.height_m(),
          .elevation_m = message.elevation_m(),
          .rim_sides_m = message.rim_sides_m(),
          .rim_ends_m = message.rim_ends_m(),
          .walk_over = message.walk_over(),
          .round = message.round(),
          .seat = message.seat(),
          // What is made to be looked over has a flag; a catalogue has no other word for tables.
          .sat_at = message.sat_at() || message.category().ends_with("table"),
          .category = message.category(),
          .host = -1};
}

void ObjectToProto(const Object& object, const Scene& scene, v1::Object& message) {
  message.set_id(object.id);
  message.set_name(object.name);
  message.set_role(ToProto(kRoles, object.role));
  message.set_kind(ToProto(kKinds, object.kind));
  if (object.zone >= 0) message.set_zone_id(scene.zones[static_cast<size_t>(object.zone)].id);
  message.set_width_m(object.footprint.width_m);
  message.set_depth_m(object.footprint.depth_m);
  message.set_height_m(object.height_m);
  message.set_elevation_m(object.elevation_m);
  message.set_rim_sides_m(object.rim_sides_m);
  message.set_rim_ends_m(object.rim_ends_m);
  message.set_walk_over(object.walk_over);
  message.set_round(object.round);
  message.set_seat(object.seat);
  message.set_category(object.category);
  if (object.host >= 0) message.set_host_id(scene.objects[static_cast<size_t>(object.host)].id);
}

absl::Status BadPlacement(int index, const std::string& problem) {
  return InvalidArgument("placements[{}]{}", index, problem);
}

// What hangs and is called to a window: curtains, blinds.
void MarkAtWindows(const v1::LayoutGraph& graph, Scene& scene) {
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (edge.type() != "under_window") continue;
    for (const v1::Argument& argument : edge.arguments()) {
      const int object = scene.IndexOf(argument.value().text());
      if (object < 0) continue;
      Object& what = scene.objects[static_cast<size_t>(object)];
      what.at_window = what.kind == ObjectKind::kWall;
    }
  }
}

// What seats are called round, or drawn up to, is sat at.
void MarkSatAt(const v1::LayoutGraph& graph, Scene& scene) {
  const auto text_of = [](const v1::ConstraintEdge& edge, std::string_view name) {
    const auto argument = std::ranges::find(edge.arguments(), name, &v1::Argument::name);
    return argument == edge.arguments().end() ? std::string() : argument->value().text();
  };
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    int table = edge.type() == "surround" ? scene.IndexOf(text_of(edge, "center")) : -1;
    if (edge.type() == "next_to" && text_of(edge, "object_side") == "front" &&
        text_of(edge, "target_side") == "front") {
      const int seat = scene.IndexOf(text_of(edge, "object"));
      if (seat >= 0 && scene.objects[static_cast<size_t>(seat)].seat) table = scene.IndexOf(text_of(edge, "target"));
    }
    if (table >= 0) scene.objects[static_cast<size_t>(table)].sat_at = true;
  }
}

// Seats that are called round a round table.
void MarkAtRound(const v1::LayoutGraph& graph, Scene& scene) {
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (edge.type() != "surround") continue;
    const auto center = std::ranges::find(edge.arguments(), "center", &v1::Argument::name);
    const int table = center == edge.arguments().end() ? -1 : scene.IndexOf(center->value().text());
    if (table < 0 || !scene.objects[static_cast<size_t>(table)].round) continue;
    for (const v1::Argument& argument : edge.arguments()) {
      for (const std::string& id : argument.value().texts().items()) {
        if (const int seat = scene.IndexOf(id); seat >= 0) scene.objects[static_cast<size_t>(seat)].at_round = true;
      }
    }
  }
}

Polygon PolygonFromProto(const v1::Polygon& message) {
  Polygon polygon;
  for (const v1::Point2& p : message.vertices()) polygon.vertices.push_back({p.x_m(), p.y_m()});
  return polygon;
}

v1::Polygon PolygonToProto(const Polygon& polygon) {
  v1::Polygon message;
  for (const Vec2<double>& p : polygon.vertices) {
    v1::Point2& point = *message.add_vertices();
    point.set_x_m(p.x);
    point.set_y_m(p.y);
  }
  return message;
}

}  // namespace

absl::StatusOr<Room> RoomFromProto(const v1::Room& message) {
  RETURN_IF_ERROR(Validate(message));
  Room room;
  room.floor = PolygonFromProto(message.floor());
  std::vector<std::string> names;
  for (const v1::Wall& wall : message.walls()) names.push_back(wall.name());
  room.walls = WallsOf(room.floor, names);
  room.height_m = message.height_m();
  for (const v1::Opening& opening : message.openings()) room.openings.push_back(OpeningFromProto(opening, room));
  for (const v1::Socket& socket : message.sockets()) {
    room.sockets.push_back({.id = socket.id(),
                            .wall = room.WallIndex(socket.wall()),
                            .offset_m = socket.offset_m(),
                            .height_m = socket.height_m()});
  }
  return room;
}

v1::Room RoomToProto(const Room& room) {
  v1::Room message;
  *message.mutable_floor() = PolygonToProto(room.floor);
  for (const Wall& wall : room.walls) message.add_walls()->set_name(wall.name);
  message.set_height_m(room.height_m);
  for (const Opening& opening : room.openings) OpeningToProto(opening, room, *message.add_openings());
  for (const Socket& socket : room.sockets) {
    v1::Socket& out = *message.add_sockets();
    out.set_id(socket.id);
    out.set_wall(room.walls[static_cast<size_t>(socket.wall)].name);
    out.set_offset_m(socket.offset_m);
    out.set_height_m(socket.height_m);
  }
  return message;
}

absl::StatusOr<Scene> SceneFromProto(const v1::LayoutGraph& graph) {
  RETURN_IF_ERROR(Validate(graph));
  ASSIGN_OR_RETURN(Room room, RoomFromProto(graph.room()));
  Scene scene;
  scene.room = std::move(room);
  for (const v1::Zone& zone : graph.zone_plan().zones()) scene.zones.push_back({.id = zone.id(), .name = zone.name()});
  for (const v1::Object& object : graph.object_list().objects()) {
    scene.objects.push_back(ObjectFromProto(object, scene));
  }
  for (int i = 0; i < graph.object_list().objects_size(); ++i) {
    const std::string& host = graph.object_list().objects(i).host_id();
    if (!host.empty()) scene.objects[static_cast<size_t>(i)].host = scene.IndexOf(host);
  }
  MarkAtWindows(graph, scene);
  MarkSatAt(graph, scene);
  MarkAtRound(graph, scene);
  return scene;
}

v1::LayoutGraph GraphFromScene(const Scene& scene) {
  v1::LayoutGraph graph;
  *graph.mutable_room() = RoomToProto(scene.room);
  for (const Zone& zone : scene.zones) {
    v1::Zone& message = *graph.mutable_zone_plan()->add_zones();
    message.set_id(zone.id);
    message.set_name(zone.name);
  }
  for (const Object& object : scene.objects) ObjectToProto(object, scene, *graph.mutable_object_list()->add_objects());
  return graph;
}

absl::StatusOr<PartialLayout> PosesFromPlacements(const Scene& scene, const PlacementList& placements) {
  PartialLayout result{.layout = Layout(scene.objects.size()), .placed = std::vector<bool>(scene.objects.size())};
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& p = placements[i];
    const int object = scene.IndexOf(p.object_id());
    if (object < 0) return BadPlacement(i, fmt::format(".object_id: \"{}\" is not an object here", p.object_id()));
    const auto index = static_cast<size_t>(object);
    if (result.placed[index]) return BadPlacement(i, fmt::format(".object_id: \"{}\" is placed twice", p.object_id()));
    if (!std::isfinite(p.x_m()) || !std::isfinite(p.y_m()) || !std::isfinite(p.theta_rad())) {
      return BadPlacement(
          i, fmt::format(": {}, {}, {} is not a pose; all must be finite", p.x_m(), p.y_m(), p.theta_rad()));
    }
    result.layout[index] = {.x_m = p.x_m(), .y_m = p.y_m(), .theta_rad = p.theta_rad()};
    result.placed[index] = true;
  }
  return result;
}

PlacementList PlacementsFromPoses(const Scene& scene, const Layout& layout, const std::vector<bool>& placed) {
  PlacementList placements;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    if (!placed.empty() && !placed[i]) continue;
    v1::Placement& placement = *placements.Add();
    placement.set_object_id(scene.objects[i].id);
    placement.set_x_m(layout[i].x_m);
    placement.set_y_m(layout[i].y_m);
    placement.set_z_m(scene.BottomOf(static_cast<int>(i)));
    placement.set_theta_rad(WrapHeading(layout[i].theta_rad));
  }
  return placements;
}

}  // namespace flair
