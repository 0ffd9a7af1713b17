// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/note_json.h"

#include <cmath>

#include "nlohmann/json.hpp"

namespace flair::cli {
namespace {

using Json = nlohmann::ordered_json;

// Texts may hold what is no UTF-8 when the layout is a stranger's.
std::string Dumped(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

Json JsonOf(const Demand& demand);
Json JsonOf(const ObjectNote& object);
Json JsonOf(const ZoneNote& zone);

template <typename Items>
Json ListOf(const Items& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(JsonOf(item));
  return list;
}

Json JsonOf(const Demand& demand) {
  Json json = {{"fate", FateName(demand.fate)}, {"about_it", demand.about_it}};
  if (!demand.sentence_id.empty()) json["sentence_id"] = demand.sentence_id;
  if (!demand.text.empty()) json["sentence"] = demand.text;
  if (!demand.reason.empty()) json["reason"] = demand.reason;
  json["edge_ids"] = demand.edge_ids;
  json["types"] = demand.types;
  if (!demand.other_ids.empty()) json["other_object_ids"] = demand.other_ids;
  if (!demand.shortfall.empty()) json["shortfall"] = demand.shortfall;
  if (demand.missed_by) {
    json["missed_by"] = *demand.missed_by;
    json["unit"] = demand.unit;
  }
  return json;
}

Json JsonOf(const ObjectNote& object) {
  Json json = {{"id", object.id}, {"name", object.name}, {"role", object.role}, {"placed", object.placed}};
  if (!object.zone_id.empty()) json["zone_id"] = object.zone_id;
  if (object.requested) json["requested"] = true;
  if (object.pinned) json["pinned"] = true;
  if (object.placed) {
    json["stands"] = object.standing;
    json["x_m"] = object.placement.x_m();
    json["y_m"] = object.placement.y_m();
    json["z_m"] = object.placement.z_m();
    json["theta_rad"] = object.placement.theta_rad();
  }
  json["demands"] = ListOf(object.demands);
  if (!object.followers.empty()) json["followers"] = object.followers;
  if (!object.remarks.empty()) json["remarks"] = object.remarks;
  return json;
}

Json JsonOf(const ZoneNote& zone) {
  Json json = {{"id", zone.id}, {"name", zone.name}};
  if (!zone.purpose.empty()) json["purpose"] = zone.purpose;
  json["objects"] = ListOf(zone.objects);
  return json;
}

}  // namespace

std::string NoteJson(const LayoutNote& note) {
  const DemandCount count = CountDemands(note);
  Json json = {{"room", note.room},
               {"demand_count",
                {{"holds", count.held},
                 {"missed", count.missed},
                 {"dropped", count.dropped},
                 {"not_understood", count.not_understood}}}};
  json["zones"] = ListOf(note.zones);
  if (!note.homeless.empty()) json["demands_of_no_object"] = ListOf(note.homeless);
  json["left_out"] = note.left_out;
  json["clashes"] = note.clashes;
  json["remarks"] = note.remarks;
  return Dumped(json);
}

std::string ObjectJson(const ObjectNote& object) { return Dumped(JsonOf(object)); }

}  // namespace flair::cli
