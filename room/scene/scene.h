// SPDX-License-Identifier: GPL-3.0-or-later
// A room with its zones and what is to be placed in it. Where things stand is kept apart: a Layout is one Pose per
// object.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "room/geometry/footprint.h"
#include "room/geometry/pose.h"
#include "room/scene/room.h"

namespace flair {

struct Zone {
  std::string id;
  std::string name;
};

enum class ObjectRole { kPrimary, kSecondary, kTertiary };
// What carries an object.
enum class ObjectKind { kFloor, kWall, kCeiling, kSurface };

struct Object {
  std::string id;
  std::string name;
  ObjectRole role = ObjectRole::kSecondary;
  ObjectKind kind = ObjectKind::kFloor;
  // Index in Scene::zones, -1 for none.
  int zone = -1;
  Footprint footprint;
  double height_m = 0;
  // Of its underside above what carries it (above the floor for wall and ceiling objects).
  double elevation_m = 0;
  // A rug, a mat, a carpet: never collides.
  bool walk_over = false;
  std::string category;
  // Index in Scene::objects of what it stands on or is attached to, -1 for none.
  int host = -1;
};

// Stands on the floor and is in the way.
inline bool IsSolid(const Object& object) { return object.kind == ObjectKind::kFloor && !object.walk_over; }

struct Scene {
  Room room;
  std::vector<Zone> zones;
  std::vector<Object> objects;

  // -1 when there is none of that id.
  int IndexOf(std::string_view object_id) const;
  int ZoneIndexOf(std::string_view zone_id) const;
  // Whether `object` stands on `carrier` or is attached to it, directly or through others; true of an object and
  // itself. What stands on the floor is carried by nothing else, whatever is said of its host.
  bool Carries(int carrier, int object) const;
  // Underside of an object above the floor; that of a surface object follows its host's top.
  double BottomOf(int object) const;
  double TopOf(int object) const { return BottomOf(object) + objects[static_cast<size_t>(object)].height_m; }
};

// One pose per object of a scene, in its order.
using Layout = std::vector<Pose<double>>;

}  // namespace flair
