// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/scene.h"

#include <fmt/format.h>

#include <algorithm>

namespace flair {

int Scene::IndexOf(std::string_view object_id) const {
  for (size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].id == object_id) return static_cast<int>(i);
  }
  return -1;
}

int Scene::ZoneIndexOf(std::string_view zone_id) const {
  for (size_t i = 0; i < zones.size(); ++i) {
    if (zones[i].id == zone_id) return static_cast<int>(i);
  }
  return -1;
}

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
