// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/status.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/v1/object_list.pb.h"
#include "language_worker/model/floor_objects_step.h"
#include "language_worker/model/prompt_text.h"

namespace flair::language {

// Step C iii with a model: adds to the floor objects what hangs, stands on them or lies on the floor, each with its
// host and its placement sentence. Errors as Conversation::Ask; the list stays as it was then.
absl::Status AskTertiaries(const ObjectsRequest& request, const ModelTools& tools, llm::Conversation& conversation,
                           IdMaker& ids, v1::ObjectList& list);

// What is wrong with an answer that reads well: larger than the room or than what it stands on, standing on nothing.
std::vector<llm::Fault> CheckTertiaries(const ObjectsRequest& request, const ModelTools& tools,
                                        const v1::ObjectList& floor_objects, const model::v1::TertiariesAnswer& answer);

// Adds the objects of an answer from which what was wrong has been left out.
void AddTertiaries(const ObjectsRequest& request, const ModelTools& tools, const model::v1::TertiariesAnswer& answer,
                   IdMaker& ids, v1::ObjectList& list);

}  // namespace flair::language
