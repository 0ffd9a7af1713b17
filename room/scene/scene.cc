// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/scene.h"

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
    if (objects[static_cast<size_t>(object)].kind == ObjectKind::kFloor) return false;
    object = objects[static_cast<size_t>(object)].host;
  }
  return false;
}

double Scene::BottomOf(int object) const {
  double bottom = 0;
  // A chain of hosts is at most as long as the list; anything longer is a circle and ends here.
  for (size_t steps = 0; object >= 0 && steps <= objects.size(); ++steps) {
    const Object& o = objects[static_cast<size_t>(object)];
    bottom += o.elevation_m;
    if (o.kind != ObjectKind::kSurface || o.host < 0) break;
    object = o.host;
    bottom += objects[static_cast<size_t>(object)].height_m;
  }
  return bottom;
}

}  // namespace flair
