// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/model_call.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/recorded/conversion.h"
#include "language_worker/recorded/recorded_room.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"

namespace flair::language {

// What the language phase made of a recorded room.
struct ImportedAnswers {
  v1::Room room;
  v1::ZonePlan zones;
  v1::ObjectList objects;
  // Cleaned.
  v1::ConstraintList constraints;
  std::vector<v1::ModelCall> calls;
  // By step.
  std::map<std::string, Conversion> conversions;
};

// Runs the language phase for the room's brief with a RecordedRoomClient, and writes every question and answer into
// `folder`, from which ReplayingLlmClient gives them again: the same questions are asked wherever the brief is designed
// with these prompts. Errors as those of the steps and of RecordingLlmClient.
absl::StatusOr<ImportedAnswers> ImportAnswers(const RecordedRoom& room, const Handbook& handbook,
                                              const llm::PromptLibrary& prompts, const std::string& folder);

}  // namespace flair::language
