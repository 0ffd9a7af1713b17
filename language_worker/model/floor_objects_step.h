// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/model/furniture_index.h"
#include "language_worker/model/model_tools.h"

namespace flair::language {

// What the steps about objects are given.
struct ObjectsRequest {
  const v1::Brief& brief;
  const v1::Room& room;
  const v1::ZonePlan& zones;
};

// Steps C i and ii with a model: primaries in zone order and secondaries, counts expanded. Things that the handbook
// knows to hang or to lie are taken as tertiaries, at the end. `ids` gets their ids. Errors as Conversation::Ask.
absl::StatusOr<v1::ObjectList> AskFloorObjects(const ObjectsRequest& request, const ModelTools& tools,
                                               llm::Conversation& conversation, IdMaker& ids);

// What is wrong with an answer that reads well: larger than the room, covering the floor, hundreds, named twice, zones
// without a primary. Equal objects that are listed one by one are doubtful, not wrong.
std::vector<llm::Fault> CheckFloorObjects(const ObjectsRequest& request, const ModelTools& tools,
                                          const model::v1::FloorObjectsAnswer& answer);

// The objects of an answer from which what was wrong has been left out.
v1::ObjectList ToObjectList(const ObjectsRequest& request, const ModelTools& tools,
                            const model::v1::FloorObjectsAnswer& answer, IdMaker& ids);

}  // namespace flair::language
