// SPDX-License-Identifier: GPL-3.0-or-later
// The handbook's answers to one step about objects, among a model's answers to the other.
#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/model/floor_objects_step.h"

namespace flair::language {

// Steps C i and ii. `ids` knows their ids. Errors as ReadBrief.
absl::StatusOr<v1::ObjectList> UsualFloorObjects(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids);

// Step C iii: adds what the handbook completes such floor objects with, and leaves what is there as it is. Errors as
// ReadBrief; the list stays as it was then.
absl::Status AddUsualTertiaries(const ObjectsRequest& request, const ModelTools& tools, IdMaker& ids,
                                v1::ObjectList& list);

}  // namespace flair::language
