// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/model/v1/style_answers.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/model_call.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/recorded/recorded_room.h"
#include "language_worker/recorded/recorded_text.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"

namespace flair::language {

// What the prompts of the language steps list, read back: a model that answers from a recording has to name objects and
// sentences by the ids that it is asked with.

// A line of a prompt that lists objects: equal ones.
struct PromptObjects {
  // One or more, in order.
  std::vector<std::string> ids;
  // What all of them are called together; the id of a single one.
  std::string group;
  // As the prompt or, where it does not tell it, the id has it.
  std::string name;
  // Empty when they are in none.
  std::string zone_id;
  double width_m = 0;
  double depth_m = 0;
};

// A sentence in the cleaning prompt, or in one of the translation, with the objects of the heading above it.
struct PromptSentence {
  std::string id;
  std::vector<std::string> subject_ids;
  std::string text;
};

// The lines of that form, in their order; others are passed over. Read any text. Objects: of the language steps
// ("- chair_1 to chair_4, together chair (dining): 0.45 x 0.5 x 0.9 m") and of the translation ("- chair_1, chair_2:
// "dining chair", 0.45 x 0.5, dining, on a wall").
std::vector<PromptObjects> ReadPromptObjects(std::string_view prompt);
std::vector<PromptSentence> ReadPromptSentences(std::string_view prompt);

// "dining_chair_3" without its number.
std::string_view WithoutNumber(std::string_view id);

// How a prompt calls the recorded objects.
class PromptIds {
 public:
  // Matches by name, zone and size, equal ones in their order; then, if `loosely`, by name alone: sizes may have been
  // mended.
  PromptIds(const std::vector<const v1::Object*>& objects, std::vector<PromptObjects> listed, bool loosely = false);

  // Empty when the prompt does not list the object.
  const std::string& IdOf(size_t object) const { return places_[object].id; }

  // Names that together mean these objects: a group's when it is meant whole, else ids; in the order of the objects.
  // Objects that the prompt does not list have none.
  std::vector<std::string> NamesOf(const std::vector<int>& objects) const;

 private:
  struct Place {
    int group = -1;
    std::string id;
  };

  std::vector<PromptObjects> listed_;
  std::vector<Place> places_;
};

// A recorded room as typed answers to the steps of the language phase. Prompts say by which ids objects and sentences
// are called now; what a prompt does not list (a piece that was left out since) is kept as a remark. What the
// recording has no figure for (heights, the purpose of a zone), and the style, is the handbook's, or plain.
// Immutable, thread-safe.
class RecordedAnswers {
 public:
  // Both must outlive it.
  RecordedAnswers(const RecordedRoom& room, const Handbook& handbook);

  model::v1::RoomAnswer Room() const;
  model::v1::ZonesAnswer Zones() const;
  model::v1::FloorObjectsAnswer FloorObjects() const;
  model::v1::TertiariesAnswer Tertiaries(std::string_view prompt, Conversion& conversion) const;
  // The handbook's. `names`: how the prompt calls objects and openings.
  model::v1::StyleAnswer Style(const std::vector<std::string>& names) const;
  model::v1::IntraAnswer Intra(std::string_view prompt, Conversion& conversion) const;
  model::v1::InterAnswer Inter(std::string_view prompt, Conversion& conversion) const;

 private:
  // The sentences of two texts, of the primaries and of the secondaries, as the recorded model cleaned them if it did.
  std::vector<RecordedSentence> Sentences(ConstraintTextKind kind, Conversion& conversion) const;
  // Equal for objects that are called alike.
  std::string NameOf(int object) const;
  double HeightOf(const v1::Object& object) const;
  // `placement` and `hosts` may be empty.
  model::v1::TertiaryAnswer Tertiary(const v1::Object& object, const std::string& placement,
                                     const std::vector<std::string>& hosts) const;

  const RecordedRoom& room_;
  const Handbook& handbook_;
  const FurnitureIndex furniture_;
  const std::vector<const v1::Object*> floor_, tertiaries_;
  const size_t primary_count_;
  const ObjectNames floor_names_;
  std::vector<std::string> zone_ids_;
};

// Gives the calls that the recorded model translated its sentences to back to the sentences of a translation prompt. A
// recording does not say which call is of which sentence: a call goes to the sentence about its objects whose words
// name what the function does, the feature and the distance best; calls without such a sentence are kept in the
// remarks. `step` names the pass ("translation.inter"). Every sentence gets an entry.
model::v1::CallsAnswer FindCalls(const RecordedRoom& room, std::string_view step, std::string_view prompt,
                                 Conversion& conversion);

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
