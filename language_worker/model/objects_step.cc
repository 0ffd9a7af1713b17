// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/objects_step.h"

#include "language_worker/model/tertiaries_step.h"
#include "language_worker/model/usual_objects.h"

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
  if (absl::Status status = AddUsualTertiaries(request, tools, ids, *list); !status.ok()) return status;
  AddStandIn(failure, *list);
  return list;
}

}  // namespace flair::language
