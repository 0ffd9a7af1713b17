// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/layout_note.h"

#include <algorithm>
#include <map>
#include <set>

#include "cli/explain/call_words.h"
#include "cli/explain/demands.h"
#include "cli/explain/sentence_words.h"
#include "cli/explain/standing.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/shortfall.h"
#include "room/geometry/polygon.h"
#include "room/validation/validate.h"

namespace flair::cli {
namespace {

// "a door in the south wall", "2 windows in the west wall".
std::string OpeningsInWords(const Room& room) {
  std::vector<std::string> parts;
  for (const auto& [kind, word] : {std::pair{OpeningKind::kDoor, "door"}, std::pair{OpeningKind::kWindow, "window"}}) {
    std::map<int, int> count_of_wall;
    for (const Opening& opening : room.openings) count_of_wall[opening.wall] += opening.kind == kind ? 1 : 0;
    for (const auto& [wall, count] : count_of_wall) {
      if (count == 0) continue;
      parts.push_back(fmt::format("{} in {}",
                                  count == 1 ? fmt::format("a {}", word) : fmt::format("{} {}s", count, word),
                                  WallInWords(room.walls[static_cast<size_t>(wall)])));
    }
  }
  return Joined(parts);
}

std::string RoomInWords(const v1::Room& message, const Room& room) {
  const std::string type = message.room_type().empty() ? "room" : message.room_type();
  const bool vowel = std::string("aeiou").find(type.front()) != std::string::npos;
  const Vec2<double> extent = BoundsOf(room.floor).max;
  std::string text = fmt::format(
      "{} {} of {:.4g} m x {:.4g} m{} ({:.3g} m2), {:.3g} m high", vowel ? "An" : "A", type, extent.x, extent.y,
      room.walls.size() == 4 ? "" : fmt::format(" with {} walls", room.walls.size()), Area(room.floor), room.height_m);
  const std::string openings = OpeningsInWords(room);
  return text + (openings.empty() ? "." : fmt::format(", with {}.", openings));
}

std::string RoleName(v1::ObjectRole role) {
  if (role == v1::OBJECT_ROLE_PRIMARY) return "primary";
  return role == v1::OBJECT_ROLE_TERTIARY ? "tertiary" : "secondary";
}

class NoteMaker {
 public:
  NoteMaker(const v1::SolvedLayout& layout, const Scene& scene, const PartialLayout& where)
      : layout_(layout), scene_(scene), where_(where) {}

  LayoutNote Make() {
    note_.room = RoomInWords(layout_.graph().room(), scene_.room);
    DescribeObjects();
    AddDemands();
    AddRemarks();
    SortIntoZones();
    return std::move(note_);
  }

 private:
  void DescribeObjects() {
    for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
      const v1::Object& object = layout_.graph().object_list().objects(i);
      ObjectNote& told = objects_.emplace_back();
      told.id = object.id();
      told.name = optimizer::NameForPeople(scene_, i);
      told.zone_id = object.zone_id();
      told.role = RoleName(object.role());
      told.requested = object.requested();
      told.placed = where_.placed[static_cast<size_t>(i)];
      if (told.placed) told.standing = Standing(scene_, where_, i);
    }
    for (const v1::Placement& placement : layout_.placements()) Of(placement.object_id())->placement = placement;
    for (const v1::Placement& pin : layout_.graph().pinned_placements()) {
      if (ObjectNote* const told = Of(pin.object_id())) told->pinned = true;
    }
  }

  void AddDemands() {
    for (AssignedDemand& assigned : CollectDemands(layout_, scene_)) {
      if (assigned.object < 0) {
        note_.homeless.push_back(std::move(assigned.demand));
        continue;
      }
      ObjectNote& told = objects_[static_cast<size_t>(assigned.object)];
      AddFollower(told, assigned.demand);
      told.demands.push_back(std::move(assigned.demand));
    }
  }

  void AddFollower(const ObjectNote& follower, const Demand& demand) {
    if (demand.fate != DemandFate::kHolds || demand.other_ids.empty()) return;
    if (std::none_of(demand.types.begin(), demand.types.end(), DrawsNear)) return;
    for (const std::string& id : demand.other_ids) {
      ObjectNote* const leader = Of(id);
      const bool alike = std::find(demand.types.begin(), demand.types.end(), "surround") != demand.types.end() &&
                         id != demand.other_ids.front();
      if (leader == nullptr || alike || leader->role == "tertiary") continue;
      std::vector<std::string>& names = leader->followers;
      if (std::find(names.begin(), names.end(), follower.name) == names.end()) names.push_back(follower.name);
    }
  }

  void AddRemarks() {
    const v1::LayoutGraph& graph = layout_.graph();
    for (const v1::Omission& omission : graph.object_list().omissions()) {
      note_.left_out.push_back(fmt::format("{}{}: {}", Capital(omission.name()),
                                           omission.requested() ? " (asked for)" : "", omission.reason()));
    }
    for (const auto* list : {&graph.room().diagnostics(), &graph.zone_plan().diagnostics(),
                             &graph.object_list().diagnostics(), &layout_.diagnostics()}) {
      for (const v1::Diagnostic& remark : *list) {
        ObjectNote* const told = Of(remark.subject_id());
        (told != nullptr ? told->remarks : note_.remarks).push_back(remark.message());
      }
    }
    for (const ObjectNote& told : objects_) {
      if (told.placed) continue;
      note_.left_out.push_back(told.remarks.empty() ? fmt::format("{} is not placed.", Capital(told.name))
                                                    : Joined(told.remarks));
    }
    for (const v1::Contradiction& clash : layout_.contradictions()) note_.clashes.push_back(clash.explanation());
  }

  void SortIntoZones() {
    for (const v1::Zone& zone : layout_.graph().zone_plan().zones()) {
      note_.zones.push_back({zone.id(), zone.name(), zone.purpose(), {}});
    }
    note_.zones.push_back({"", "the whole room", "", {}});
    for (ObjectNote& told : objects_) {
      const auto zone = std::find_if(note_.zones.begin(), note_.zones.end() - 1,
                                     [&](const ZoneNote& candidate) { return candidate.id == told.zone_id; });
      zone->objects.push_back(std::move(told));
    }
    std::erase_if(note_.zones, [](const ZoneNote& zone) { return zone.objects.empty(); });
  }

  ObjectNote* Of(const std::string& id) {
    const int index = scene_.IndexOf(id);
    return index < 0 ? nullptr : &objects_[static_cast<size_t>(index)];
  }

  const v1::SolvedLayout& layout_;
  const Scene& scene_;
  const PartialLayout& where_;
  std::vector<ObjectNote> objects_;
  LayoutNote note_;
};

}  // namespace

absl::StatusOr<LayoutNote> MakeLayoutNote(const v1::SolvedLayout& layout) {
  if (const absl::Status status = Validate(layout); !status.ok()) return status;
  absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  if (!scene.ok()) return scene.status();
  // Names are read by people here: "towel_rack" is written "towel rack".
  for (Object& object : scene->objects) std::replace(object.name.begin(), object.name.end(), '_', ' ');
  const absl::StatusOr<PartialLayout> where = PosesFromPlacements(*scene, layout.placements());
  if (!where.ok()) return where.status();
  return NoteMaker(layout, *scene, *where).Make();
}

DemandCount CountDemands(const LayoutNote& note) {
  DemandCount count;
  std::set<std::string> seen;
  const auto add = [&](const Demand& demand) {
    const std::string& key = demand.sentence_id.empty() ? demand.edge_ids.front() : demand.sentence_id;
    if (!seen.insert((demand.sentence_id.empty() ? "edge " : "sentence ") + key).second) return;
    ++(demand.fate == DemandFate::kHolds     ? count.held
       : demand.fate == DemandFate::kMissed  ? count.missed
       : demand.fate == DemandFate::kDropped ? count.dropped
                                             : count.not_understood);
  };
  for (const ZoneNote& zone : note.zones) {
    for (const ObjectNote& object : zone.objects) std::for_each(object.demands.begin(), object.demands.end(), add);
  }
  std::for_each(note.homeless.begin(), note.homeless.end(), add);
  return count;
}

const char* FateName(DemandFate fate) {
  switch (fate) {
    case DemandFate::kHolds:
      return "holds";
    case DemandFate::kMissed:
      return "missed";
    case DemandFate::kDropped:
      return "dropped";
    case DemandFate::kNotUnderstood:
      return "not understood";
  }
  return "";
}

}  // namespace flair::cli
