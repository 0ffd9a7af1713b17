// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/floor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/model/object_size.h"

namespace flair::language {

using model::v1::FloorObjectAnswer;
using model::v1::FloorObjectsAnswer;

FloorPlan::FloorPlan(const ObjectsRequest& request, const ModelTools& tools, const FloorObjectsAnswer& answer)
    : request_(request), tools_(tools), answer_(answer) {}

v1::ObjectList FloorPlan::ToList(IdMaker& ids) {
  JoinEqualLines();
  for (const model::v1::LeftOutAnswer& left : answer_.left_out()) {
    v1::Omission& omission = *list_.add_omissions();
    omission.set_name(left.name());
    omission.set_reason(left.reason());
    omission.set_requested(true);
  }
  MarkPrimaries();
  LeaveOutTooMany();
  LeaveOutTooLarge();
  for (Line& line : lines_) line.ids = ids.MakeSeveral(line.answer->name(), line.count, "object");
  for (const v1::Zone& zone : request_.zones.zones()) {
    for (const Line& line : lines_) {
      if (line.answer->zone() == zone.id()) AddObjects(line, /*primaries=*/true, list_);
    }
  }
  for (const Line& line : lines_) AddObjects(line, /*primaries=*/false, list_);
  for (const Line& line : lines_) AddTertiaries(line, list_);
  return std::move(list_);
}

void FloorPlan::JoinEqualLines() {
  for (const FloorObjectAnswer& object : answer_.objects()) {
    const auto same = std::find_if(lines_.begin(), lines_.end(), [&](const Line& line) {
      return PlainName(line.answer->name()) == PlainName(object.name()) && line.answer->zone() == object.zone() &&
             line.answer->width_m() == object.width_m() && line.answer->depth_m() == object.depth_m();
    });
    if (same != lines_.end()) {
      same->count += object.count();
    } else {
      lines_.push_back({&object, object.count(), false, KindOf(object)});
    }
  }
}

void FloorPlan::MarkPrimaries() {
  for (const v1::Zone& zone : request_.zones.zones()) {
    Line* primary = nullptr;
    for (const bool named : {true, false}) {
      for (Line& line : lines_) {
        const bool here = line.answer->zone() == zone.id() && line.kind == v1::OBJECT_KIND_FLOOR;
        if (primary == nullptr && here && line.answer->primary() == named) primary = &line;
      }
    }
    if (primary != nullptr) {
      primary->primary = true;
    } else {
      AddDiagnostic(v1::SEVERITY_NOTE, "empty_zone",
                    fmt::format("The model listed no furniture for the zone \"{}\".", zone.id()), list_);
    }
  }
}

int FloorPlan::Count() const {
  int count = 0;
  for (const Line& line : lines_) count += line.count;
  return count;
}

double FloorPlan::Covered_m2() const {
  double covered_m2 = 0;
  for (const Line& line : lines_) {
    if (line.kind == v1::OBJECT_KIND_FLOOR) covered_m2 += line.count * line.answer->width_m() * line.answer->depth_m();
  }
  return covered_m2;
}

void FloorPlan::LeaveOutTooMany() {
  const std::string reason =
      fmt::format("The model listed {} pieces; a room takes {} at most.", Count(), kMostFloorObjects);
  while (Count() > kMostFloorObjects && LeaveOutOne(/*floor_only=*/false, reason)) {
  }
}

void FloorPlan::LeaveOutTooLarge() {
  const double floor_m2 = ExtentOf(request_.room).area_m2;
  while (Covered_m2() > kMostCover * floor_m2 &&
         LeaveOutOne(/*floor_only=*/true,
                     fmt::format("What the model listed covers {:.0f} % of the floor; {:.0f} % at most.",
                                 100 * Covered_m2() / floor_m2, 100 * kMostCover))) {
  }
}

bool FloorPlan::LeaveOutOne(bool floor_only, const std::string& reason) {
  const auto rank = [](const Line& line) {
    return (line.primary && line.count == 1 ? 2 : 0) + (line.answer->requested() ? 1 : 0);
  };
  auto victim = lines_.end();
  for (auto line = lines_.begin(); line != lines_.end(); ++line) {
    if (floor_only && line->kind != v1::OBJECT_KIND_FLOOR) continue;
    if (victim == lines_.end() || rank(*line) <= rank(*victim)) victim = line;
  }
  if (victim == lines_.end() || rank(*victim) >= 2) return false;
  const std::string& name = victim->answer->name();
  const bool told = std::any_of(list_.omissions().begin(), list_.omissions().end(),
                                [&](const v1::Omission& omission) { return omission.name() == name; });
  if (!told) {
    v1::Omission& omission = *list_.add_omissions();
    omission.set_name(name);
    omission.set_reason(reason);
    omission.set_requested(victim->answer->requested());
  }
  if (--victim->count == 0) lines_.erase(victim);
  return true;
}

v1::ObjectKind FloorPlan::KindOf(const FloorObjectAnswer& answer) const {
  if (IsRugName(answer.name())) return v1::OBJECT_KIND_UNSPECIFIED;  // walked over
  const hb::Furniture* furniture = tools_.furniture.FindExact(answer.name());
  if (furniture == nullptr) return v1::OBJECT_KIND_FLOOR;
  constexpr double kFlat_m = 0.2;
  if (furniture->kind() == hb::FURNITURE_KIND_CEILING) return v1::OBJECT_KIND_CEILING;
  if (furniture->kind() == hb::FURNITURE_KIND_WALL && answer.depth_m() <= kFlat_m) return v1::OBJECT_KIND_WALL;
  return v1::OBJECT_KIND_FLOOR;
}

void FloorPlan::Describe(const Line& line, const std::string& id, v1::Object& object) const {
  const FloorObjectAnswer& answer = *line.answer;
  object.set_id(id);
  const std::string name = PlainName(answer.name());
  object.set_name(name.empty() ? answer.name() : name);
  object.set_zone_id(answer.zone());
  object.set_width_m(answer.width_m());
  object.set_depth_m(answer.depth_m());
  object.set_height_m(std::min(answer.height_m(), request_.room.height_m()));
  object.set_description(answer.description());
  object.set_requested(answer.requested());
  if (const hb::Furniture* furniture = tools_.furniture.Find(answer.name())) object.set_category(furniture->category());
}

void FloorPlan::AddObjects(const Line& line, bool primaries, v1::ObjectList& list) const {
  if (line.kind != v1::OBJECT_KIND_FLOOR) return;
  for (size_t i = 0; i < line.ids.size(); ++i) {
    if ((line.primary && i == 0) != primaries) continue;
    v1::Object& object = *list.add_objects();
    Describe(line, line.ids[i], object);
    object.set_role(primaries ? v1::OBJECT_ROLE_PRIMARY : v1::OBJECT_ROLE_SECONDARY);
    object.set_kind(v1::OBJECT_KIND_FLOOR);
  }
}

void FloorPlan::AddTertiaries(const Line& line, v1::ObjectList& list) const {
  if (line.kind == v1::OBJECT_KIND_FLOOR) return;
  for (const std::string& id : line.ids) {
    v1::Object& object = *list.add_objects();
    Describe(line, id, object);
    object.set_role(v1::OBJECT_ROLE_TERTIARY);
    const bool rug = line.kind == v1::OBJECT_KIND_UNSPECIFIED;
    object.set_kind(rug ? v1::OBJECT_KIND_FLOOR : line.kind);
    object.set_walk_over(rug);
    const double free_m = request_.room.height_m() - object.height_m();
    const hb::Furniture* furniture = tools_.furniture.Find(line.answer->name());
    if (object.kind() == v1::OBJECT_KIND_CEILING) object.set_elevation_m(free_m);
    if (object.kind() == v1::OBJECT_KIND_WALL) object.set_elevation_m(std::min(furniture->elevation_m(), free_m));
  }
}

}  // namespace flair::language
