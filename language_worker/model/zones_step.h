// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/model/model_tools.h"

namespace flair::language {

// Step B with a model: the zones, most important first, those of the brief's own objects among them. Errors as
// Conversation::Ask.
absl::StatusOr<v1::ZonePlan> AskZones(const v1::Brief& brief, const v1::Room& room, const ModelTools& tools,
                                      llm::Conversation& conversation);

// What is wrong with an answer that reads well: names given twice, more zones than such a floor has uses for.
std::vector<llm::Fault> CheckZones(const v1::Room& room, const model::v1::ZonesAnswer& answer);

v1::ZonePlan ToZonePlan(const model::v1::ZonesAnswer& answer);

// The handbook's zones, those of the brief's own objects among them. Errors as ReadBrief.
absl::StatusOr<v1::ZonePlan> PlanWantedZones(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook);

// Adds the zones that the brief's own objects name and the plan lacks, with a remark.
void AddWantedZones(const v1::Brief& brief, v1::ZonePlan& plan);

}  // namespace flair::language
