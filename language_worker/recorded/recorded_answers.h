// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/model/v1/style_answers.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/model/object_size.h"
#include "language_worker/recorded/object_names.h"
#include "language_worker/recorded/prompt_lines.h"
#include "language_worker/recorded/recorded_room.h"
#include "language_worker/recorded/recorded_text.h"

namespace flair::language {

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

}  // namespace flair::language
