// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "llm/answers/choices.h"
#include "llm/answers/extract_json.h"
#include "llm/answers/fault.h"
#include "llm/answers/length_unit.h"

namespace flair::llm {

// Reads a JSON value into a message, whose fields are named as in the proto, and says of everything that is not as the
// fields' facts want it what it is and what would be right. Elements of lists keep their numbers: a bad one is there,
// with what of it could be read. Tolerant where the meaning is certain: lengths with units, numbers as text, names in
// another case or with spaces, null or nothing for what may be absent, one element where a list is wanted, an outer
// object or a list alone around or instead of the root. Lengths without a unit are in `bare_unit`, or metres when it is
// null. Pure; any value is good input.
std::vector<Fault> ReadJson(nlohmann::json value, const FieldChoices& choices, google::protobuf::Message& message,
                            const LengthUnit* bare_unit = nullptr);

// ExtractJson with the fields of a type.
ExtractedJson ExtractAnswer(std::string_view answer, const google::protobuf::Descriptor& type);

// ExtractAnswer, then ReadJson: all that is wrong with what a model wrote. Pure; any bytes are good input.
std::vector<Fault> ReadAnswer(std::string_view answer, const FieldChoices& choices, google::protobuf::Message& message,
                              const LengthUnit* bare_unit = nullptr);

}  // namespace flair::llm
