// SPDX-License-Identifier: GPL-3.0-or-later
// The empty room as a value: floor, walls, openings and sockets, in room frame R (x east, y north, metres); and the
// floor that a door needs: what its leaf sweeps, and the passage in front of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair {

// One edge of the floor, walked counter-clockwise: the room lies on its left.
struct Wall {
  std::string name;
  Vec2<double> start;
  Vec2<double> end;
  // Unit vector into the room.
  Vec2<double> inward_normal;
  double length_m = 0;

  // Unit vector from start to end.
  Vec2<double> Along() const { return {inward_normal.y, -inward_normal.x}; }
  // The point `offset_m` from the start.
  Vec2<double> PointAt(double offset_m) const { return start + offset_m * Along(); }
  // Heading of an object whose back is flush on this wall: its front looks along the inward normal.
  double BackHeading() const;
  // Distance of a point from the wall's line, positive on the room's side.
  template <typename T>
  T Height(const Vec2<T>& p) const {
    return (p.x - T(start.x)) * T(inward_normal.x) + (p.y - T(start.y)) * T(inward_normal.y);
  }
  // Metres along the wall from its start to the foot of p.
  template <typename T>
  T Offset(const Vec2<T>& p) const {
    return (p.x - T(start.x)) * T(inward_normal.y) - (p.y - T(start.y)) * T(inward_normal.x);
  }
};

enum class OpeningKind { kDoor, kWindow };
enum class HingeSide { kStart, kEnd };
enum class DoorSwing { kInward, kOutward, kSliding, kNone };

struct DoorLeaf {
  // The end of the opening that carries the hinges, walking along the wall.
  HingeSide hinge = HingeSide::kStart;
  DoorSwing swing = DoorSwing::kInward;
  double swing_angle_rad = 1.5707963267948966;
};

struct Opening {
  std::string id;
  OpeningKind kind = OpeningKind::kDoor;
  // Index in Room::walls.
  int wall = 0;
  // From the wall's start to the nearer end.
  double offset_m = 0;
  double width_m = 0;
  double sill_height_m = 0;
  double head_height_m = 0;
  // Doors only.
  std::optional<DoorLeaf> leaf;
};

struct Socket {
  std::string id;
  int wall = 0;
  // From the wall's start to its centre.
  double offset_m = 0;
  double height_m = 0;
};

struct Room {
  Polygon floor;
  // Edge i of the floor.
  std::vector<Wall> walls;
  std::vector<Opening> openings;
  std::vector<Socket> sockets;
  double height_m = 3;

  // -1 when there is no wall of that name.
  int WallIndex(std::string_view name) const;
  // The opening or socket on the floor's edge; a socket has zero length.
  Segment SegmentOf(const Opening& opening) const;
  Segment SegmentOf(const Socket& socket) const;
};

// Walls of a floor: edge i becomes wall i. Names come from the caller; an empty list names a rectangle's walls by the
// compass and all others wall_1, wall_2 ...
std::vector<Wall> WallsOf(const Polygon& floor, const std::vector<std::string>& names = {});

// A rectangle of `width_m` (x) by `depth_m` (y) with walls south, east, north, west.
Room RectangularRoom(double width_m, double depth_m);

// The end of the opening that carries the hinges, on the floor's edge. The start when there is no leaf.
Vec2<double> HingePoint(const Room& room, const Opening& door);

// The sector of radius width_m that the leaf sweeps inside the room, as polygons around the arc (so that they cover the
// arc: at most 0.3 % of the radius too large), counter-clockwise and convex: two where the leaf opens wider than a
// quarter turn. Empty for doors that do not open inwards.
std::vector<Polygon> ConvexSwingAreas(const Room& room, const Opening& door, int arc_pieces = 8);

// "the south wall", "the garden wall". One that is just numbered is named by the side it is on, and by its length where
// others are on that side: "the 1.50 m north wall". `wall` is one of the room's.
std::string WallName(const Room& room, const Wall& wall);

// "the window in the east wall", "window 2 in the east wall" when there are several.
std::string NameForPeople(const Room& room, const Opening& opening);

// The rectangle in front of the opening, `depth_m` into the room, widened by `margin_m` at both ends. Convex.
Polygon PassageArea(const Room& room, const Opening& door, double depth_m, double margin_m = 0);

}  // namespace flair
