// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/floor_objects_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/model/floor_plan.h"
#include "language_worker/model/object_size.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"

namespace flair::language {
namespace {

using llm::Fault;
using llm::FaultKind;
using model::v1::FloorObjectAnswer;
using model::v1::FloorObjectsAnswer;

ObjectSize SizeOf(const FloorObjectAnswer& answer) { return {answer.width_m(), answer.depth_m(), answer.height_m()}; }

void CheckObject(const FloorObjectAnswer& object, const std::string& path, const ObjectsRequest& request,
                 const ModelTools& tools, std::vector<Fault>& faults) {
  const ObjectSize size = SizeOf(object);
  const FloorExtent floor = ExtentOf(request.room);
  if (!FitsFloor(size, floor)) {
    faults.push_back({path + ".width_m", fmt::format("{} is larger than the room of {:g} m x {:g} m",
                                                     FootprintText(size), floor.width_m, floor.depth_m)});
  } else if (const std::string odd = OddSize(size, tools.furniture.Find(object.name())); !odd.empty()) {
    faults.push_back({path + ".width_m", odd, FaultKind::kDoubtful});
  }
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

}  // namespace

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

absl::StatusOr<v1::ObjectList> AskFloorObjects(const ObjectsRequest& request, const ModelTools& tools,
                                               llm::Conversation& conversation, IdMaker& ids) {
  const absl::StatusOr<BriefFacts> facts = ReadBrief(request.brief, tools.handbook);
  if (!facts.ok()) return facts.status();
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
  question.judge_lengths = JudgeOf<FloorObjectsAnswer>(request, tools);
  const absl::StatusOr<llm::Reply> reply = conversation.Ask(question);
  if (!reply.ok()) return reply.status();
  if (reply->As<FloorObjectsAnswer>().objects().empty()) {
    return absl::DataLossError("step \"objects.floor\": the model's answer has no usable object, also after a repair");
  }
  v1::ObjectList list = ToObjectList(request, tools, reply->As<FloorObjectsAnswer>(), ids);
  AddMissingWishes(*facts, tools, list);
  AddFaults("objects.floor", reply->faults, list);
  if (absl::Status status = Validate(list, request.zones); !status.ok()) {
    return UnusableResult("objects.floor", status);
  }
  return list;
}

v1::ObjectList ToObjectList(const ObjectsRequest& request, const ModelTools& tools, const FloorObjectsAnswer& answer,
                            IdMaker& ids) {
  return FloorPlan(request, tools, answer).ToList(ids);
}

}  // namespace flair::language
