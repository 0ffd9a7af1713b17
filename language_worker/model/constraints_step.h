// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/model/floor_objects_step.h"

namespace flair::language {

// Step D i and ii with a model, both asked at once, and the tertiaries' placements as sentences. Where the handbook
// may stand in and one of the two answers is of no use, its sentences take the place of that one's, with a remark.
// Errors as Conversation::Ask.
absl::StatusOr<v1::ConstraintList> AskConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const ModelTools& tools, llm::Conversation& conversation);

}  // namespace flair::language
