// SPDX-License-Identifier: GPL-3.0-or-later
// What is declared of the fields of an answer, in the forms that schema and reader need.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flair/model/v1/annotations.pb.h"

namespace flair::llm {

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

}  // namespace flair::llm
