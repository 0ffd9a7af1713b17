// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/objects_step.h"

#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/model/tertiaries_step.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {

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
  if (failure.ok()) return list;
  if (!conversation.MayStandIn(failure)) return failure;
  if (!floor_failure.ok()) return BothFailed(floor_failure, failure);
  RETURN_IF_ERROR(AddUsualTertiaries(request, tools, ids, *list));
  AddStandIn(failure, *list);
  return list;
}

absl::StatusOr<v1::ObjectList> UsualFloorObjects(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids) {
  absl::StatusOr<v1::ObjectList> list = ListFloorObjects(request.brief, request.room, request.zones, tools.handbook);
  if (!list.ok()) return list;
  for (const v1::Object& object : list->objects()) ids.Take(object.id());
  return list;
}

absl::Status AddUsualTertiaries(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids,
                                v1::ObjectList& list) {
  // The handbook knows what stands on a "desk", not on an "oak writing desk".
  v1::ObjectList by_class = list;
  for (v1::Object& object : *by_class.mutable_objects()) {
    if (const hb::Furniture* furniture = tools.furniture.Find(object.name())) object.set_name(furniture->name());
  }
  const absl::StatusOr<v1::ObjectList> tertiaries =
      ListTertiaries(request.brief, request.room, request.zones, by_class, tools.handbook);
  if (!tertiaries.ok()) return tertiaries.status();
  for (const v1::Object& tertiary : tertiaries->objects()) {
    v1::Object& object = *list.add_objects();
    object = tertiary;
    object.set_id(ids.MakeLike(tertiary.id()));
  }
  list.mutable_omissions()->MergeFrom(tertiaries->omissions());
  return absl::OkStatus();
}

}  // namespace flair::language
