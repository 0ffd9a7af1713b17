// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/model/objects_step.h"

#include "language_worker/model/tertiaries_step.h"

namespace flair::language {

absl::StatusOr<v1::ObjectList> AskObjects(const ObjectsRequest& request, const ModelTools& tools,
                                          llm::Conversation& conversation) {
  IdMaker ids;
  absl::StatusOr<v1::ObjectList> list = AskFloorObjects(request, tools, conversation, ids);
  if (!list.ok()) return list;
  if (absl::Status status = AskTertiaries(request, tools, conversation, ids, *list); !status.ok()) return status;
  return list;
}

}  // namespace flair::language
