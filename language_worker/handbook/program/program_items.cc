// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/program/program_items.h"

#include <algorithm>

namespace flair::language {
namespace {

template <typename List>
bool Names(const List& list, const std::string& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

}  // namespace

bool IsFloorPiece(const hb::Furniture& furniture) {
  return !furniture.walk_over() &&
         (furniture.kind() == hb::FURNITURE_KIND_FLOOR || furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED);
}

bool Lists(const std::vector<ProgramItem>& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(), [&](const auto& item) { return item.furniture->name() == name; });
}

bool Lists(const RoomProgram& program, const std::string& name) {
  return Lists(program.floor_items, name) || Lists(program.tertiary_items, name);
}

bool HasZone(const RoomProgram& program, const std::string& name) {
  return std::any_of(program.zones.begin(), program.zones.end(), [&](const auto& z) { return z.name() == name; });
}

std::string HomeOf(const hb::Furniture& furniture, const RoomProgram& program) {
  for (const hb::ZoneSpec& zone : program.zones) {
    if (Names(zone.primaries(), furniture.name())) return zone.name();
  }
  for (const std::string& hint : furniture.zone_hints()) {
    if (HasZone(program, hint)) return hint;
  }
  for (const hb::Relation& relation : furniture.relations()) {
    for (const ProgramItem& item : program.floor_items) {
      if (Names(relation.targets(), item.furniture->name())) return item.zone;
    }
  }
  return program.zones.empty() ? "" : program.zones.front().name();
}

int PlacesOn(const hb::Furniture& furniture) {
  constexpr double kOnABenchM = 0.5, kOnASofaM = 0.6, kTwoInABedM = 1.3;
  const std::string& category = furniture.category();
  const double width_m = furniture.width_m().typical();
  if (category == "bench") return std::max(1, static_cast<int>(width_m / kOnABenchM));
  if (category == "sofa") return std::max(1, static_cast<int>(width_m / kOnASofaM));
  if (category == "bed") return width_m >= kTwoInABedM || furniture.name() == "bunk bed" ? 2 : 1;
  return category == "chair" || category == "stool" || category == "armchair" ? 1 : 0;
}

void Remove(const std::string& name, RoomProgram& program) {
  for (auto* list : {&program.floor_items, &program.tertiary_items}) {
    std::erase_if(*list, [&](const ProgramItem& item) { return item.furniture->name() == name; });
  }
}

}  // namespace flair::language
