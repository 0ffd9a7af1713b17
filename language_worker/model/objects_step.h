// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/model/floor_objects_step.h"

namespace flair::language {

// Steps C i to iii with a model: floor objects first, then what completes them. Where the handbook may stand in and one
// of the two answers is of no use, it answers that one alone, with a remark. Errors as Conversation::Ask.
absl::StatusOr<v1::ObjectList> AskObjects(const ObjectsRequest& request, const ModelTools& tools,
                                          llm::Conversation& conversation);

// Steps C i and ii. `ids` knows their ids. Errors as ReadBrief.
absl::StatusOr<v1::ObjectList> UsualFloorObjects(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids);

// Step C iii: adds what the handbook completes such floor objects with, and leaves what is there as it is. Errors as
// ReadBrief; the list stays as it was then.
absl::Status AddUsualTertiaries(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids,
                                v1::ObjectList& list);

}  // namespace flair::language
