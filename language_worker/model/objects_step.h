// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/model/floor_objects_step.h"

namespace flair::language {

// Steps C i to iii with a model: floor objects first, then what completes them. Where the handbook may stand in and one
// of the two answers is of no use, it answers that one alone, with a remark. Errors as Conversation::Ask.
absl::StatusOr<v1::ObjectList> AskObjects(const ObjectsRequest& request, const ModelTools& tools,
                                          llm::Conversation& conversation);

}  // namespace flair::language
