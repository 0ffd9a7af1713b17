// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/model_call.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/recorded/recorded_answers.h"
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
  // The same with what is implied, as it is translated.
  v1::ConstraintList completed;
  std::vector<v1::ModelCall> calls;
  // By step.
  std::map<std::string, Conversion> conversions;
};

// Runs the language phase for the room's brief with a RecordedRoomClient, and writes every question and answer into
// `folder`, from which a replay gives them again: the same questions are asked wherever the brief is designed
// with these prompts. Errors as those of the steps and of MakeRecordingClient.
absl::StatusOr<ImportedAnswers> ImportAnswers(const RecordedRoom& room, const Handbook& handbook,
                                              const llm::PromptLibrary& prompts, const std::string& folder);

// A model that answers the steps of the language phase and of the translation with what another model wrote when a room
// was recorded, as typed answers. Repairs get the same answer again: that is what was recorded. Other steps are
// NOT_FOUND. Usage is estimated from the lengths of messages, schema and answer. Thread-safe.
class RecordedRoomClient final : public llm::LlmClient {
 public:
  // Both must outlive it.
  RecordedRoomClient(const RecordedRoom& room, const Handbook& handbook) : room_(room), answers_(room, handbook) {}

  absl::StatusOr<llm::ChatAnswer> Ask(const llm::ChatRequest& request, runtime::CallContext& call) override;
  // Names the recording: another one gives other answers to the same brief.
  std::string identity() const override { return "gpt-4o, recorded as free text " + room_.digest; }

  // What became of the texts of the steps that were asked so far.
  std::map<std::string, Conversion> conversions() const;

 private:
  absl::StatusOr<std::string> Answer(const std::string& step, const llm::ChatRequest& request);

  const RecordedRoom& room_;
  const RecordedAnswers answers_;
  mutable std::mutex mutex_;
  std::map<std::string, Conversion> conversions_;
};

}  // namespace flair::language
