// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "flair/model/v1/object_answers.pb.h"
#include "language_worker/handbook/objects/list_objects.h"
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
using model::v1::TertiariesAnswer;
using model::v1::TertiaryAnswer;

constexpr int kMostTertiaries = 60;
constexpr double kThickestOnWall_m = 0.8;
// Odd sizes of smaller things are not worth a call.
constexpr double kLarge_m = 1;
constexpr double kUsualMiddleOnWall_m = 1.55;

int AskedCount(double area_m2) { return std::clamp(static_cast<int>(std::lround(4 + area_m2 / 3)), 5, 14); }

const v1::Object* FindObject(const v1::ObjectList& list, const std::string& id) {
  for (const v1::Object& object : list.objects()) {
    if (object.id() == id) return &object;
  }
  return nullptr;
}

// The objects that an answer names as its place.
std::vector<const v1::Object*> HostsOf(const TertiaryAnswer& answer, const std::vector<ObjectGroup>& groups,
                                       const v1::ObjectList& list) {
  std::vector<const v1::Object*> hosts;
  if (!answer.has_at()) return hosts;
  for (const std::string& id : IdsOf(answer.at(), groups)) hosts.push_back(FindObject(list, id));
  return hosts;
}

bool FitsTop(const TertiaryAnswer& answer, const v1::Object& host) {
  return std::max(answer.width_m(), answer.depth_m()) <= std::max(host.width_m(), host.depth_m()) &&
         std::min(answer.width_m(), answer.depth_m()) <= std::min(host.width_m(), host.depth_m());
}

void CheckObject(const TertiaryAnswer& object, const std::string& path, const ObjectsRequest& request,
                 const std::vector<const v1::Object*>& hosts, const ModelTools& tools, std::vector<Fault>& faults) {
  const ObjectSize size{object.width_m(), object.depth_m(), object.height_m()};
  const std::optional<Fault> footprint =
      FootprintFault(path, size, ExtentOf(request.room), tools.furniture.FindExact(object.name()));
  const bool large = std::max(size.width_m, size.depth_m) > kLarge_m;
  if (footprint && (large || footprint->kind == FaultKind::kWrong)) faults.push_back(*footprint);
  if (object.kind() == "surface" && hosts.empty()) {
    faults.push_back({path + ".at", "is null; name the object that it stands on"});
  } else if (object.kind() == "surface" && !FitsTop(object, *hosts.front())) {
    faults.push_back({path + ".width_m",
                      fmt::format("{} is larger than the top of {}, {:g} m x {:g} m; made to fit it",
                                  FootprintText(size), object.at(), hosts.front()->width_m(), hosts.front()->depth_m()),
                      FaultKind::kMended});
  }
  if (object.kind() == "wall" && object.depth_m() > kThickestOnWall_m) {
    faults.push_back(
        {path + ".depth_m",
         fmt::format("is {}; what hangs on a wall stands out {} m at most", object.depth_m(), kThickestOnWall_m),
         FaultKind::kDoubtful});
  }
}

v1::ObjectKind KindOf(const std::string& word) {
  if (word == "wall") return v1::OBJECT_KIND_WALL;
  if (word == "ceiling") return v1::OBJECT_KIND_CEILING;
  return word == "surface" ? v1::OBJECT_KIND_SURFACE : v1::OBJECT_KIND_FLOOR;
}

double ElevationOf(const TertiaryAnswer& answer, double height_m, const v1::Object* host,
                   const hb::Furniture* furniture, double room_height_m) {
  const double most_m = std::max(0.0, room_height_m - height_m);
  if (answer.kind() == "ceiling") return most_m;
  if (answer.kind() != "wall") return 0;
  if (answer.has_elevation_m()) return std::min(answer.elevation_m(), most_m);
  double elevation_m = std::max(0.0, kUsualMiddleOnWall_m - height_m / 2);
  if (furniture != nullptr && furniture->kind() == hb::FURNITURE_KIND_WALL) elevation_m = furniture->elevation_m();
  // Above its host when that reaches up to it.
  if (host != nullptr) elevation_m = std::max(elevation_m, host->height_m() + 0.1);
  return std::min(elevation_m, most_m);
}

// The answer's sentence; of several that stand on several equal things, one for each.
std::string PlacementOf(const TertiaryAnswer& answer, const std::vector<const v1::Object*>& hosts, size_t number) {
  if (answer.kind() != "surface" || answer.count() < 2 || hosts.size() < 2) return answer.placement();
  const v1::Object& host = *hosts[number % hosts.size()];
  return fmt::format("The {} {} is on the {} {}.", Ordinal(number), PlainName(answer.name()),
                     Ordinal(number % hosts.size()), host.name());
}

class TertiaryMaker {
 public:
  TertiaryMaker(const ObjectsRequest& request, const ModelTools& tools, const TertiaryAnswer& answer,
                std::vector<const v1::Object*> hosts)
      : request_(request), answer_(answer), hosts_(std::move(hosts)), furniture_(tools.furniture.Find(answer.name())) {}

  v1::Object Make(const std::string& id, size_t number) const {
    const v1::Object* host = hosts_.empty() ? nullptr : hosts_[number % hosts_.size()];
    v1::Object object = DescribedObject(answer_, id, request_.room, furniture_);
    object.set_role(v1::OBJECT_ROLE_TERTIARY);
    object.set_kind(KindOf(answer_.kind()));
    if (host != nullptr) {
      object.set_host_id(host->id());
      object.set_zone_id(host->zone_id());
      if (object.kind() == v1::OBJECT_KIND_SURFACE && !FitsTop(answer_, *host)) FitTo(*host, object);
    }
    object.set_elevation_m(ElevationOf(answer_, object.height_m(), host, furniture_, request_.room.height_m()));
    object.set_walk_over(object.kind() == v1::OBJECT_KIND_FLOOR && LiesFlat());
    object.set_placement(PlacementOf(answer_, hosts_, number));
    return object;
  }

 private:
  static void FitTo(const v1::Object& host, v1::Object& object) {
    object.set_width_m(std::min(object.width_m(), host.width_m()));
    object.set_depth_m(std::min(object.depth_m(), host.depth_m()));
  }

  bool LiesFlat() const {
    constexpr double kFlat_m = 0.06;
    return IsRugName(answer_.name()) || answer_.height_m() <= kFlat_m;
  }

  const ObjectsRequest& request_;
  const TertiaryAnswer& answer_;
  const std::vector<const v1::Object*> hosts_;
  const hb::Furniture* furniture_;
};

// What is wrong with an answer that reads well: larger than the room or than what it stands on, standing on nothing.
std::vector<Fault> CheckTertiaries(const ObjectsRequest& request, const ModelTools& tools,
                                   const v1::ObjectList& floor_objects, const TertiariesAnswer& answer) {
  const std::vector<ObjectGroup> groups = GroupObjects(floor_objects, /*floor_only=*/true);
  std::vector<Fault> faults;
  int count = 0;
  for (int i = 0; i < answer.objects_size(); ++i) {
    const TertiaryAnswer& object = answer.objects(i);
    count += object.count();
    CheckObject(object, fmt::format("objects[{}]", i), request, HostsOf(object, groups, floor_objects), tools, faults);
  }
  if (count > kMostTertiaries) {
    faults.push_back(
        {"objects", fmt::format("has {} objects in all; at most {}", count, kMostTertiaries), FaultKind::kDoubtful});
  }
  return faults;
}

// Adds the objects of an answer from which what was wrong has been left out.
void AddTertiaries(const ObjectsRequest& request, const ModelTools& tools, const TertiariesAnswer& answer, IdMaker& ids,
                   v1::ObjectList& list) {
  const v1::ObjectList floor_objects = list;
  const std::vector<ObjectGroup> groups = GroupObjects(floor_objects, /*floor_only=*/true);
  const ObjectWords words(floor_objects, request.room);
  int left = kMostTertiaries;
  for (const TertiaryAnswer& object : answer.objects()) {
    const int count = std::min(object.count(), left);
    if (count < object.count()) {
      v1::Omission& omission = *list.add_omissions();
      omission.set_name(object.name());
      omission.set_reason(fmt::format("The model listed more than {} things of this sort.", kMostTertiaries));
      omission.set_requested(object.requested());
    }
    if (count == 0) continue;
    left -= count;
    const TertiaryMaker maker(request, tools, object, HostsOf(object, groups, floor_objects));
    const std::vector<std::string> made_ids = ids.MakeSeveral(object.name(), count, "object");
    for (size_t i = 0; i < made_ids.size(); ++i) {
      v1::Object& made = *list.add_objects();
      made = maker.Make(made_ids[i], i);
      made.set_placement(words.InWords(made.placement()));
    }
  }
}

// Steps C i and ii without a model. `ids` gets their ids.
absl::StatusOr<v1::ObjectList> UsualFloorObjects(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids) {
  absl::StatusOr<v1::ObjectList> list = ListFloorObjects(request.brief, request.room, request.zones, tools.handbook);
  if (!list.ok()) return list;
  for (const v1::Object& object : list->objects()) ids.Take(object.id());
  return list;
}

// Step C iii without a model: adds what the handbook completes such floor objects with, and leaves what is there as it
// is. The list stays as it was when it fails.
absl::Status AddUsualTertiaries(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids,
                                v1::ObjectList& list) {
  // The handbook knows what stands on a "desk", not on an "oak writing desk".
  v1::ObjectList by_class = list;
  for (v1::Object& object : *by_class.mutable_objects()) {
    if (const hb::Furniture* furniture = tools.furniture.Find(object.name())) object.set_name(furniture->name());
  }
  ASSIGN_OR_RETURN(const v1::ObjectList tertiaries,
                   ListTertiaries(request.brief, request.room, request.zones, by_class, tools.handbook));
  for (const v1::Object& tertiary : tertiaries.objects()) {
    v1::Object& object = *list.add_objects();
    object = tertiary;
    object.set_id(ids.MakeLike(tertiary.id()));
  }
  list.mutable_omissions()->MergeFrom(tertiaries.omissions());
  return absl::OkStatus();
}

}  // namespace

absl::Status AskTertiaries(const ObjectsRequest& request, const ModelTools& tools, llm::Conversation& conversation,
                           IdMaker& ids, v1::ObjectList& list) {
  const std::vector<ObjectGroup> groups = GroupObjects(list, /*floor_only=*/true);
  const double area_m2 = ExtentOf(request.room).area_m2;
  llm::Question question = MakeQuestion(tools, "objects.tertiary", "tertiaries",
                                        {{"brief", llm::QuoteData(request.brief.text())},
                                         {"room", ShortRoomText(request.room)},
                                         {"objects", GroupsText(groups)},
                                         {"count", fmt::format("{}", AskedCount(area_m2))}},
                                        TertiariesAnswer::default_instance());
  question.choices["flair.model.v1.TertiaryAnswer.at"] = GroupChoices(groups);
  question.check = llm::CheckOf<TertiariesAnswer>(
      [&](TertiariesAnswer& answer) { return CheckTertiaries(request, tools, list, answer); });
  const auto make = [&](const TertiariesAnswer& answer) -> absl::StatusOr<v1::ObjectList> {
    v1::ObjectList all = list;
    AddTertiaries(request, tools, answer, ids, all);
    return all;
  };
  ASSIGN_OR_RETURN(
      list, (AskFor<TertiariesAnswer, v1::ObjectList>(question, conversation, make, [&](const v1::ObjectList& all) {
        return Validate(all, request.zones);
      })));
  return absl::OkStatus();
}

absl::StatusOr<v1::ObjectList> AskObjects(const ObjectsRequest& request, const ModelTools& tools,
                                          llm::Conversation& conversation) {
  IdMaker ids;
  absl::StatusOr<v1::ObjectList> list = AskFloorObjects(request, tools, conversation, ids);
  const absl::Status floor_failure = list.status();
  if (!floor_failure.ok()) {
    // A model that was not reached need not be asked the next question at once.
    if (!conversation.MayStandIn(floor_failure) || !absl::IsDataLoss(floor_failure)) return floor_failure;
    list = UsualFloorObjects(request, tools, ids);
    if (!list.ok()) return list;
    AddStandIn(floor_failure, *list);
  }
  const absl::Status failure = AskTertiaries(request, tools, conversation, ids, *list);
  if (!failure.ok()) {
    if (!conversation.MayStandIn(failure)) return failure;
    if (!floor_failure.ok()) return BothFailed(floor_failure, failure);
    RETURN_IF_ERROR(AddUsualTertiaries(request, tools, ids, *list));
    AddStandIn(failure, *list);
  }
  RETURN_IF_ERROR(TellMissing(request.brief, request.room, tools.handbook, *list));
  return list;
}

}  // namespace flair::language
