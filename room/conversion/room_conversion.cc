// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/conversion/room_conversion.h"

#include <algorithm>

#include "room/validation/validate.h"

namespace flair {
namespace {

DoorSwing SwingFromProto(v1::DoorSwing swing) {
  switch (swing) {
    case v1::DOOR_SWING_OUTWARD:
      return DoorSwing::kOutward;
    case v1::DOOR_SWING_SLIDING:
      return DoorSwing::kSliding;
    case v1::DOOR_SWING_NONE:
      return DoorSwing::kNone;
    default:
      return DoorSwing::kInward;
  }
}

v1::DoorSwing SwingToProto(DoorSwing swing) {
  switch (swing) {
    case DoorSwing::kInward:
      return v1::DOOR_SWING_INWARD;
    case DoorSwing::kOutward:
      return v1::DOOR_SWING_OUTWARD;
    case DoorSwing::kSliding:
      return v1::DOOR_SWING_SLIDING;
    case DoorSwing::kNone:
      return v1::DOOR_SWING_NONE;
  }
  return v1::DOOR_SWING_UNSPECIFIED;
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
                            .swing = SwingFromProto(message.leaf().swing()),
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
  leaf.set_swing(SwingToProto(opening.leaf->swing));
  leaf.set_swing_angle_rad(opening.leaf->swing_angle_rad);
}

}  // namespace

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

absl::StatusOr<Room> RoomFromProto(const v1::Room& message) {
  if (absl::Status status = Validate(message); !status.ok()) return status;
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

}  // namespace flair
