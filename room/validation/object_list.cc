// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/checks.h"

namespace flair::validation {
namespace {

// Two hundred take a solve a minute and a half on one core, and the time grows with more than the square.
constexpr int kMostObjects = 250;
constexpr Range kExtent{.least = 0, .most = 20, .open_least = true};
constexpr Range kHeight{.least = 0, .most = 12, .open_least = true};
constexpr Range kElevation{.least = 0, .most = 12};

void CheckObject(const v1::Object& object, const Known& known, const Field& at) {
  at["name"].Text(object.name(), 1, 200);
  at["role"].Enum(object.role(), v1::ObjectRole_IsValid(object.role()));
  at["kind"].Enum(object.kind(), v1::ObjectKind_IsValid(object.kind()));
  at["width_m"].InRange(object.width_m(), kExtent);
  at["depth_m"].InRange(object.depth_m(), kExtent);
  at["height_m"].InRange(object.height_m(), kHeight);
  at["elevation_m"].InRange(object.elevation_m(), kElevation);
  at["description"].Text(object.description(), 0, 4000);
  at["placement"].Text(object.placement(), 0, 4000);
  if (!object.category().empty()) at["category"].Id(object.category());
  const bool standing = object.role() == v1::OBJECT_ROLE_PRIMARY || object.role() == v1::OBJECT_ROLE_SECONDARY;
  if (standing && object.kind() != v1::OBJECT_KIND_FLOOR && object.kind() != v1::OBJECT_KIND_UNSPECIFIED) {
    at["kind"].Reject("is {} for a {}; primaries and secondaries stand on the floor",
                      v1::ObjectKind_Name(object.kind()), v1::ObjectRole_Name(object.role()));
  }
  if (object.walk_over() && object.kind() != v1::OBJECT_KIND_FLOOR) {
    at["walk_over"].Reject("is set for {}; only what lies on the floor is walked over",
                           v1::ObjectKind_Name(object.kind()));
  }
  if (object.zone_id().empty()) {
    if (standing) at["zone_id"].Reject("is empty; every primary and secondary belongs to a zone");
  } else if (known.zones != nullptr) {
    at["zone_id"].Refers(object.zone_id(), *known.zones, "a zone");
  }
}

}  // namespace

void Check(const v1::ObjectList& list, const Known& known, const Field& at) {
  const Field objects = at["objects"];
  if (!objects.Count(list.objects_size(), 1, kMostObjects, "objects")) return;
  NameSet seen;
  for (int i = 0; i < list.objects_size(); ++i) {
    objects[i]["id"].NewId(list.objects(i).id(), seen);
    CheckObject(list.objects(i), known, objects[i]);
  }
  for (int i = 0; i < list.objects_size(); ++i) {
    const v1::Object& object = list.objects(i);
    if (object.host_id().empty()) continue;
    const Field host = objects[i]["host_id"];
    if (host.Refers(object.host_id(), seen, "an object") && object.host_id() == object.id()) {
      host.Reject("\"{}\" is the object itself", object.id());
    }
  }
  for (int i = 0; i < list.omissions_size(); ++i) {
    at["omissions"][i]["name"].Text(list.omissions(i).name(), 1, 1000);
    at["omissions"][i]["reason"].Text(list.omissions(i).reason(), 1, 4000);
  }
  CheckDiagnostics(list.diagnostics(), at["diagnostics"]);
}

NameSet ObjectIds(const v1::ObjectList& list) {
  NameSet ids;
  for (const v1::Object& object : list.objects()) ids.insert(object.id());
  return ids;
}

}  // namespace flair::validation
