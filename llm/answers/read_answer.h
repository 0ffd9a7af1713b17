// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flair/model/v1/annotations.pb.h"

namespace flair::llm {

// What is wrong with a model's answer, precisely enough to be told to the model and to a person.

// What becomes of a fault.
enum class FaultKind {
  // The meaning was certain; taken so, and not worth another call.
  kMended,
  // Asked about once; what was read is used when the model stays with it.
  kDoubtful,
  // Asked about once; when it stays, the list element that it is in is left out, or the answer when it is in none.
  kWrong,
};

struct Fault {
  // Where, as in the answer: "objects[3].width_m"; empty for the whole answer.
  std::string path;
  // The value, what is wrong with it and what would be right: "is \"very wide\"; metres, 0.05 to 20".
  std::string text;
  FaultKind kind = FaultKind::kWrong;

  // "objects[3].width_m: is ..."
  std::string Sentence() const;
};

// The value in quotes for a fault's text, at most 60 bytes of it, on one line.
std::string Quoted(std::string_view value);

// The text without what stands between double quotes: for those who do not want words of answers kept.
std::string WithoutQuotations(std::string_view text);

// Removes the list elements that kWrong faults are in (the innermost list of their path) and returns the faults that
// are in no list element, for which the answer as a whole is of no use. Paths are those of `message` before the call.
std::vector<Fault> DropFaulty(std::span<const Fault> faults, google::protobuf::Message& message);

// What is declared of the fields of an answer, in the forms that schema and reader need.

// The texts that one field may take, known only at run time: names of zones, objects, constraint types.
struct Choices {
  // In the order in which the model is shown them.
  std::vector<std::string> names;
  // Other words that certainly mean one of them; not shown.
  std::map<std::string, std::string> aliases;
};

// By full name of the field, such as "flair.model.v1.FloorObjectAnswer.zone".
using FieldChoices = std::map<std::string, Choices>;

// The choice that a text means: equal but for case, spaces, hyphens and underscores, a plural s, or an alias in that
// sense; nothing when there is none or it would be more than one.
std::optional<std::string> FindChoice(std::string_view text, const Choices& choices);

// Letters and digits of a text in lower case, bytes beyond ASCII as they are: what names are compared by.
std::string Bare(std::string_view text);

// What is declared of a field; of an undeclared one nothing.
const model::v1::FieldFacts& FactsOf(const google::protobuf::FieldDescriptor& field);

// The texts that a field may take: those chosen at run time, else those declared; nothing when any text may be.
std::optional<Choices> TextsOf(const google::protobuf::FieldDescriptor& field, const FieldChoices& choices);

bool IsWhole(const google::protobuf::FieldDescriptor& field);

// The accepted numbers of a numeric field, which is a double or an int32; those of its type where nothing is declared.
struct NumberRange {
  double least = 0;
  double most = 0;
};
NumberRange RangeOf(const google::protobuf::FieldDescriptor& field);

// Sets a numeric field, or adds to it when it is a list. `value` is in RangeOf the field, or 0.
void SetNumberField(double value, const google::protobuf::FieldDescriptor& field, google::protobuf::Message& message);

// What would be right in a field, for faults: "a number in metres, 0.05 to 20", "one of "door", "window"".
std::string RightFor(const google::protobuf::FieldDescriptor& field, const FieldChoices& choices);

// A number as text, in `unit` ("m", "deg" or none): "1.2" alone or with the name of a unit behind it, "1.2 m", "120
// cm", "90°". Nothing for anything else.
std::optional<double> ReadQuantity(std::string_view text, std::string_view unit);

// The JSON schema of an answer, compact, in the subset that servers enforce strictly: every object closed, every field
// required (those with `optional` may be null), choices as enums, numbers and lists with their limits, and the fields'
// docs as descriptions. `message` must not contain itself. Deterministic.
std::string AnswerSchema(const google::protobuf::Descriptor& message, const FieldChoices& choices);

// A name for it that the protocol accepts, such as "floor_objects_answer".
std::string AnswerSchemaName(const google::protobuf::Descriptor& message);

// The JSON of an answer.
struct ExtractedJson {
  // Discarded (`is_discarded()`) when the answer holds none; the faults then say what it holds instead.
  nlohmann::json value = nlohmann::json(nlohmann::json::value_t::discarded);
  // A truncated answer whose first list elements are whole gives those, and a doubtful fault.
  std::vector<Fault> faults;
};

// Takes the JSON out of what a model wrote: alone, between fences, with prose around it, after "thoughts", with
// comments, trailing commas or line ends within its texts. Of several values that with most of the `keys` at its root
// wins, then the later one. Faults for an empty answer, HTML, prose without JSON, JSON that does not parse, and more
// than a megabyte. Pure; any bytes are good input.
ExtractedJson ExtractJson(std::string_view answer, std::span<const std::string> keys);

// Reads a JSON value into a message, whose fields are named as in the proto, and says of everything that is not as the
// fields' facts want it what it is and what would be right. Elements of lists keep their numbers: a bad one is there,
// with what of it could be read. Beyond the schema it takes numbers as text ("1.6 m"), names in another case or with
// spaces, aliases of fields, null or nothing for what may be absent, one element where a list is wanted, and what
// AnswerRoot takes. Pure; any value is good input.
std::vector<Fault> ReadJson(nlohmann::json value, const FieldChoices& choices, google::protobuf::Message& message);

// ExtractAnswer, then ReadJson: all that is wrong with what a model wrote. Pure; any bytes are good input.
std::vector<Fault> ReadAnswer(std::string_view answer, const FieldChoices& choices, google::protobuf::Message& message);

// The text with U+FFFD for every byte that is no UTF-8.
std::string ToUtf8(std::string_view text);

// Good UTF-8 cut to at most `most` bytes at a character's start.
std::string CutCharacters(std::string_view text, size_t most);

// The same, with " …" behind it when it was longer.
std::string CutBytes(const std::string& text, size_t most);

// Good UTF-8 with spaces and line ends of all kinds as ASCII's, and without characters that nobody sees: byte order
// marks, soft hyphens, marks of direction. What joins letters stays.
std::string PlainSpaces(std::string text);

// With spaces in the place of control characters, but for those of `kept`.
std::string WithoutControls(std::string text, std::string_view kept = {});

}  // namespace flair::llm
