// SPDX-License-Identifier: GPL-3.0-or-later
// A room with its zones and what is to be placed in it. Where things stand is kept apart: a Layout is one Pose per
// object.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "room/geometry/polygon.h"
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
  // Of a top with an opening in its middle, what carries at its left and right, and at its front and back; both 0 when
  // the whole top carries.
  double rim_sides_m = 0;
  double rim_ends_m = 0;
  // A rug, a mat, a carpet: never collides.
  bool walk_over = false;
  bool round = false;
  // One sits on it.
  bool seat = false;
  // One sits at it: knees reach under its top.
  bool sat_at = false;
  // Has a place at something round, so that it stands square to no wall.
  bool at_round = false;
  std::string category;
  // Index in Scene::objects of what it stands on or is attached to, -1 for none.
  int host = -1;
  // Hangs before a window, which is then no hindrance.
  bool at_window = false;
};

// Stands on the floor and is in the way.
inline bool IsSolid(const Object& object) { return object.kind == ObjectKind::kFloor && !object.walk_over; }

// The opening in the middle of its top, such as a basin's; none when the whole top carries.
std::optional<Footprint> OpeningIn(const Object& top);

struct Scene {
  Room room;
  std::vector<Zone> zones;
  std::vector<Object> objects;

  // -1 when there is none of that id.
  int IndexOf(std::string_view object_id) const;
  int ZoneIndexOf(std::string_view zone_id) const;
  // Whether `object` stands on `carrier` or is attached to it, directly or through others; true of an object and
  // itself. What stands on the floor is carried by nothing else, whatever is said of its host; and what hangs, by
  // nothing that stands: a mirror is above its dresser, not in it.
  bool Carries(int carrier, int object) const;
  // Underside of an object above the floor; that of a surface object follows its host's top, and a ceiling object of no
  // elevation hangs from the ceiling itself.
  double BottomOf(int object) const;
  double TopOf(int object) const { return BottomOf(object) + objects[static_cast<size_t>(object)].height_m; }
};

// One pose per object of a scene, in its order.
using Layout = std::vector<Pose<double>>;

// What a surface object stands on: its host, or the highest of the placed solid floor objects under its centre; -1 when
// there is none. `placed` holds one per object.
template <typename Placed>
int CarrierOf(const Scene& scene, int object, const Layout& layout, const Placed& placed) {
  const int host = scene.objects[static_cast<size_t>(object)].host;
  if (host >= 0) return placed[static_cast<size_t>(host)] ? host : -1;
  constexpr double kRounding_m = 1e-6;
  const Vec2<double> center = Center(layout[static_cast<size_t>(object)]);
  int best = -1;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& carrier = scene.objects[i];
    if (static_cast<int>(i) == object || !placed[i] || !IsSolid(carrier)) continue;
    const Vec2<double> local = FrameOf(layout[i]).ToObject(center);
    const bool under = std::abs(local.x) <= carrier.footprint.width_m / 2 + kRounding_m &&
                       std::abs(local.y) <= carrier.footprint.depth_m / 2 + kRounding_m;
    if (under && (best < 0 || carrier.height_m > scene.objects[static_cast<size_t>(best)].height_m)) {
      best = static_cast<int>(i);
    }
  }
  return best;
}

// Underside above the floor of a placed object, wherever a surface object may stand.
template <typename Placed>
double UndersideOf(const Scene& scene, int object, const Layout& layout, const Placed& placed) {
  const Object& what = scene.objects[static_cast<size_t>(object)];
  if (what.kind != ObjectKind::kSurface) return scene.BottomOf(object);
  const int carrier = CarrierOf(scene, object, layout, placed);
  return what.elevation_m + (carrier < 0 ? 0 : scene.TopOf(carrier));
}

// "the desk"; "dining chair 2" when the scene has several of that name.
std::string NameForPeople(const Scene& scene, int object);

}  // namespace flair
