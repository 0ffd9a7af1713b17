// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "flair/model/v1/object_answers.pb.h"
#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

using llm::Fault;
using llm::FaultKind;
using model::v1::FloorObjectAnswer;
using model::v1::FloorObjectsAnswer;

// Pieces of floor furniture in all; more are left out.
constexpr int kMostFloorObjects = 60;
// Share of the floor that a model is told furniture may cover, and the share above which pieces are left out.
constexpr double kUsualCover = 0.45;
constexpr double kMostCover = 0.6;

void CheckObject(const FloorObjectAnswer& object, const std::string& path, const ObjectsRequest& request,
                 const ModelTools& tools, std::vector<Fault>& faults) {
  const std::optional<Fault> footprint = FootprintFault(path, {object.width_m(), object.depth_m(), object.height_m()},
                                                        ExtentOf(request.room), tools.furniture.Find(object.name()));
  if (footprint) faults.push_back(*footprint);
  if (object.height_m() > request.room.height_m()) {
    faults.push_back(
        {path + ".height_m",
         fmt::format("is {}; the room is {:g} m high, taken as that", object.height_m(), request.room.height_m()),
         FaultKind::kMended});
  }
}

void CheckZonesServed(const v1::ZonePlan& zones, const FloorObjectsAnswer& answer, std::vector<Fault>& faults) {
  for (const v1::Zone& zone : zones.zones()) {
    int primaries = 0, objects = 0;
    for (const FloorObjectAnswer& object : answer.objects()) {
      if (object.zone() != zone.id()) continue;
      ++objects;
      primaries += object.primary() ? 1 : 0;
    }
    if (objects == 0) {
      faults.push_back({"objects", fmt::format("has nothing for the zone \"{}\"", zone.id()), FaultKind::kDoubtful});
    } else if (primaries != 1) {
      faults.push_back(
          {"objects",
           fmt::format("has {} primaries for the zone \"{}\"; one, the first is taken", primaries, zone.id()),
           FaultKind::kMended});
    }
  }
}

// The brief's wishes of which the list has nothing are told, so that none is lost without a word.
void AddMissingWishes(const BriefFacts& facts, const ModelTools& tools, v1::ObjectList& list) {
  for (const Wish& wish : facts.wishes) {
    if (wish.furniture->kind() != hb::FURNITURE_KIND_FLOOR &&
        wish.furniture->kind() != hb::FURNITURE_KIND_UNSPECIFIED) {
      continue;
    }
    const std::string name = PlainName(wish.furniture->name());
    const auto is_it = [&](const std::string& other) {
      return tools.furniture.Find(other) == wish.furniture || PlainName(other).find(name) != std::string::npos;
    };
    bool told = false;
    for (v1::Object& object : *list.mutable_objects()) {
      if (!is_it(object.name())) continue;
      object.set_requested(true);
      told = true;
    }
    for (const v1::Omission& omission : list.omissions()) told = told || is_it(omission.name());
    if (told) continue;
    v1::Omission& omission = *list.add_omissions();
    omission.set_name(wish.furniture->name());
    omission.set_reason("The model neither listed it nor said why not.");
    omission.set_requested(true);
  }
}

// Turns an answer's floor objects into a list that fits: equal lines joined, too many and too large left out with the
// reason, one primary a zone, counts expanded.
class FloorPlan {
 public:
  // The arguments must outlive it.
  FloorPlan(const ObjectsRequest& request, const ModelTools& tools, const FloorObjectsAnswer& answer)
      : request_(request), tools_(tools), answer_(answer) {}

  v1::ObjectList ToList(IdMaker& ids) {
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

 private:
  // A line of the answer.
  struct Line {
    const FloorObjectAnswer* answer = nullptr;
    int count = 1;
    bool primary = false;
    // What carries it: floor for all but what the handbook knows better.
    v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR;
    std::vector<std::string> ids = {};
  };

  void JoinEqualLines() {
    for (const FloorObjectAnswer& object : answer_.objects()) {
      const auto same = std::ranges::find_if(lines_, [&](const Line& line) {
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

  void MarkPrimaries() {
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

  int Count() const {
    int count = 0;
    for (const Line& line : lines_) count += line.count;
    return count;
  }

  double Covered_m2() const {
    double covered_m2 = 0;
    for (const Line& line : lines_) {
      if (line.kind == v1::OBJECT_KIND_FLOOR)
        covered_m2 += line.count * line.answer->width_m() * line.answer->depth_m();
    }
    return covered_m2;
  }

  void LeaveOutTooMany() {
    const std::string reason =
        fmt::format("The model listed {} pieces; a room takes {} at most.", Count(), kMostFloorObjects);
    while (Count() > kMostFloorObjects && LeaveOutOne(/*floor_only=*/false, reason)) {
    }
  }

  void LeaveOutTooLarge() {
    const double floor_m2 = ExtentOf(request_.room).area_m2;
    while (Covered_m2() > kMostCover * floor_m2 &&
           LeaveOutOne(/*floor_only=*/true,
                       fmt::format("What the model listed covers {:.0f} % of the floor; {:.0f} % at most.",
                                   100 * Covered_m2() / floor_m2, 100 * kMostCover))) {
    }
  }

  // Takes one piece from the end of the list, primaries and what the brief names last; false when none may go.
  bool LeaveOutOne(bool floor_only, const std::string& reason) {
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
    const bool told =
        std::ranges::any_of(list_.omissions(), [&](const v1::Omission& omission) { return omission.name() == name; });
    if (!told) {
      v1::Omission& omission = *list_.add_omissions();
      omission.set_name(name);
      omission.set_reason(reason);
      omission.set_requested(victim->answer->requested());
    }
    if (--victim->count == 0) lines_.erase(victim);
    return true;
  }

  v1::ObjectKind KindOf(const FloorObjectAnswer& answer) const {
    if (IsRugName(answer.name())) return v1::OBJECT_KIND_UNSPECIFIED;  // walked over
    const hb::Furniture* furniture = tools_.furniture.FindExact(answer.name());
    if (furniture == nullptr) return v1::OBJECT_KIND_FLOOR;
    constexpr double kFlat_m = 0.2;
    if (furniture->kind() == hb::FURNITURE_KIND_CEILING) return v1::OBJECT_KIND_CEILING;
    if (furniture->kind() == hb::FURNITURE_KIND_WALL && answer.depth_m() <= kFlat_m) return v1::OBJECT_KIND_WALL;
    return v1::OBJECT_KIND_FLOOR;
  }

  v1::Object Described(const Line& line, const std::string& id) const {
    v1::Object object = DescribedObject(*line.answer, id, request_.room, tools_.furniture.Find(line.answer->name()));
    object.set_zone_id(line.answer->zone());
    return object;
  }

  void AddObjects(const Line& line, bool primaries, v1::ObjectList& list) const {
    if (line.kind != v1::OBJECT_KIND_FLOOR) return;
    for (size_t i = 0; i < line.ids.size(); ++i) {
      if ((line.primary && i == 0) != primaries) continue;
      v1::Object& object = *list.add_objects();
      object = Described(line, line.ids[i]);
      object.set_role(primaries ? v1::OBJECT_ROLE_PRIMARY : v1::OBJECT_ROLE_SECONDARY);
      object.set_kind(v1::OBJECT_KIND_FLOOR);
    }
  }

  void AddTertiaries(const Line& line, v1::ObjectList& list) const {
    if (line.kind == v1::OBJECT_KIND_FLOOR) return;
    for (const std::string& id : line.ids) {
      v1::Object& object = *list.add_objects();
      object = Described(line, id);
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

  const ObjectsRequest& request_;
  const ModelTools& tools_;
  const FloorObjectsAnswer& answer_;
  std::vector<Line> lines_;
  v1::ObjectList list_;  // of which only the omissions and remarks are filled before the end
};

// What is wrong with an answer that reads well: larger than the room, covering the floor, hundreds, zones without a
// primary.
std::vector<Fault> CheckFloorObjects(const ObjectsRequest& request, const ModelTools& tools,
                                     const FloorObjectsAnswer& answer) {
  std::vector<Fault> faults;
  double covered_m2 = 0;
  int count = 0;
  for (int i = 0; i < answer.objects_size(); ++i) {
    const FloorObjectAnswer& object = answer.objects(i);
    CheckObject(object, fmt::format("objects[{}]", i), request, tools, faults);
    count += object.count();
    if (!IsRugName(object.name())) covered_m2 += object.count() * object.width_m() * object.depth_m();
  }
  if (count > kMostFloorObjects) {
    faults.push_back(
        {"objects", fmt::format("has {} objects in all; at most {}", count, kMostFloorObjects), FaultKind::kDoubtful});
  }
  const double floor_m2 = ExtentOf(request.room).area_m2;
  if (covered_m2 > kMostCover * floor_m2) {
    faults.push_back(
        {"objects",
         fmt::format("covers {:.1f} m2 of a floor of {:.1f} m2; at most {:.1f} m2, leave out or take smaller",
                     covered_m2, floor_m2, kUsualCover * floor_m2),
         FaultKind::kDoubtful});
  }
  CheckZonesServed(request.zones, answer, faults);
  return faults;
}

}  // namespace

absl::StatusOr<v1::ObjectList> AskFloorObjects(const ObjectsRequest& request, const ModelTools& tools,
                                               llm::Conversation& conversation, IdMaker& ids) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(request.brief, tools.handbook));
  const double floor_m2 = ExtentOf(request.room).area_m2;
  llm::Question question = MakeQuestion(tools, "objects.floor", "floor_objects",
                                        {{"brief", llm::QuoteData(request.brief.text())},
                                         {"room", RoomText(request.room)},
                                         {"zones", ZonesText(request.zones)},
                                         {"area_m2", fmt::format("{:.1f}", kUsualCover * floor_m2)}},
                                        FloorObjectsAnswer::default_instance());
  llm::Choices& zones = question.choices["flair.model.v1.FloorObjectAnswer.zone"];
  for (const v1::Zone& zone : request.zones.zones()) {
    zones.names.push_back(zone.id());
    zones.aliases[zone.name()] = zone.id();
  }
  question.check = llm::CheckOf<FloorObjectsAnswer>(
      [&](FloorObjectsAnswer& answer) { return CheckFloorObjects(request, tools, answer); });
  const auto make = [&](const FloorObjectsAnswer& answer) -> absl::StatusOr<v1::ObjectList> {
    if (answer.objects().empty()) {
      return absl::DataLossError(
          "step \"objects.floor\": the model's answer has no usable object, also after a repair");
    }
    v1::ObjectList list = FloorPlan(request, tools, answer).ToList(ids);
    AddMissingWishes(facts, tools, list);
    return list;
  };
  return AskFor<FloorObjectsAnswer, v1::ObjectList>(
      question, conversation, make, [&](const v1::ObjectList& list) { return Validate(list, request.zones); });
}

}  // namespace flair::language
