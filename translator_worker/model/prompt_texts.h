// SPDX-License-Identifier: GPL-3.0-or-later
// What a translating model is told, as short lines of text.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "llm/answers/read_answer.h"
#include "translator_worker/grammar/call.h"

namespace flair::translator {

// The notation in which a model writes calls: near(sofa, bookshelf, max_distance_m=1).

// Calls of one sentence that are read; the rest is left out.
inline constexpr size_t kMostCalls = 40;

// An argument as it is written.
struct WrittenArgument {
  // Empty when it is given by its place.
  std::string name;
  // Several for a list in brackets.
  std::vector<std::string> values;
  bool in_brackets = false;
};

// A call as it is written; nothing of it is known to be right.
struct WrittenCall {
  std::string function;
  std::vector<WrittenArgument> arguments;
};

// What one text of an answer says.
struct WrittenCalls {
  std::vector<WrittenCall> calls;
  // "none(why)": that no function says it, and why.
  bool none = false;
  std::string why;
};

// Reads one call, several one after the other, or none. Takes quotes, "name: value", lists in any brackets, spaces, a
// semicolon or point at the end, code marks, and a missing last bracket. INVALID_ARGUMENT says what is no call, and
// what would be right. Pure; any text is good input.
absl::StatusOr<WrittenCalls> ReadCallText(std::string_view text);

// Reads the texts of a model's arguments as values that a parameter takes: ids and names of what the room has, sides,
// numbers with units. Borrows the request. Immutable, thread-safe.
class ArgumentReader {
 public:
  explicit ArgumentReader(const v1::TranslateRequest& request);

  // INVALID_ARGUMENT with the text and what would be right, when a value means nothing certain: "\"sofa 2\" is no
  // object; one of ...". A name that several equal objects share stands for all of them where a list is wanted.
  absl::StatusOr<v1::ArgumentValue> Read(const v1::ParameterSpec& parameter, std::span<const std::string> values) const;

 private:
  absl::StatusOr<std::string> One(const llm::Choices& choices, const char* what, const std::string& value) const;
  // The ids that a text means.
  absl::StatusOr<std::vector<std::string>> ObjectIds(const std::string& value) const;
  absl::StatusOr<v1::ArgumentValue> Single(const v1::ParameterSpec& parameter, const std::string& value) const;

  llm::Choices objects_;
  // Ids by bare name, for names that objects share.
  std::map<std::string, std::vector<std::string>> groups_;
  llm::Choices zones_;
  llm::Choices walls_;
  llm::Choices features_;
};

// A written call as one of the type: arguments by name or place. One without a name goes to the next parameter that can
// take it, past optional ones that cannot ("against_wall(bed, north)"), or to the list before it. Numbers are clamped
// to their range and the type's needs checked; `remarks` gets what was changed. INVALID_ARGUMENT says what does not fit
// and what would.
absl::StatusOr<Call> BindCall(const WrittenCall& written, const v1::ConstraintType& type, const ArgumentReader& reader,
                              std::vector<std::string>& remarks);

// One line a type: how it is called, what then holds, and an example where that says it in other words than the name.
// Names, parameters and defaults; never code.
std::string FunctionsText(std::span<const v1::ConstraintType* const> types);

// "4.00 x 5.00 m; walls north, east, ...; 1 door, 2 windows, 3 sockets".
std::string RoomText(const v1::Room& room);

std::string ZonesText(const v1::ZonePlan& zones);

// One line for equal objects that follow each other: ids, the name where the ids do not tell it, width and depth, zone,
// and where they are when not simply on the floor. Tertiaries only where the sentences are about them.
std::string ObjectsText(const v1::ObjectList& objects, std::span<const v1::Sentence* const> sentences);

// One line a sentence: id, and its text quoted as data; the ids of its subjects in a heading in brackets before it, and
// before all that follow with the same.
std::string SentencesText(std::span<const v1::Sentence* const> sentences);

struct Pass {
  v1::SentenceScope scope;
  // Name of the step, such as "translation.intra".
  std::string_view step;
  // Told to the model.
  std::string_view task;
};

inline constexpr std::array<Pass, 3> kPasses = {
    {{v1::SENTENCE_SCOPE_INTRA, "translation.intra", "These sentences are about one object and the room."},
     {v1::SENTENCE_SCOPE_INTER, "translation.inter", "These sentences are about objects among each other."},
     {v1::SENTENCE_SCOPE_TERTIARY, "translation.tertiary",
      "These sentences say where small things, rugs, lamps and wall pieces go."}}};

// The types that a pass is told of: those of the families that its sentences speak of, and of every family that is not
// one of ours, in the order of the catalogue, as far as the room has something to call them with: no lamps without a
// ceiling lamp. None is built in.
std::vector<const v1::ConstraintType*> TypesFor(const Pass& pass, const v1::TranslateRequest& request);

}  // namespace flair::translator
