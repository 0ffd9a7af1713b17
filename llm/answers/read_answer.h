// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "llm/answers/fault.h"
#include "llm/answers/field_facts.h"

namespace flair::llm {

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

// ExtractJson with the fields of a type.
ExtractedJson ExtractAnswer(std::string_view answer, const google::protobuf::Descriptor& type);

// ExtractAnswer, then ReadJson: all that is wrong with what a model wrote. Pure; any bytes are good input.
std::vector<Fault> ReadAnswer(std::string_view answer, const FieldChoices& choices, google::protobuf::Message& message);

// The object that a value means for an answer of that type: itself when it has any of the type's fields; the only
// object or list that it wraps, as {"answer": {...}} and [{...}] do; the elements of the type's only list. Else the
// value itself.
nlohmann::json AnswerRoot(nlohmann::json value, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
