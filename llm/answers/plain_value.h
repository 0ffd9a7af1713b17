// SPDX-License-Identifier: GPL-3.0-or-later
// What objects say of plain values.
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "llm/answers/length_unit.h"

namespace flair::llm {

// The plain value that an object means where a field wants one, borrowed from it: that of a schema that was filled in,
// {"type": "number", "value": 4}; for texts also that of a member such as "text" or "id", or the only member. Null for
// values that are no such object, and for fields with a notation of their own.
const nlohmann::json* PlainValueOf(const nlohmann::json& value, const google::protobuf::FieldDescriptor& field);

// The object or list that a text is the JSON of; null for none.
nlohmann::json JsonIn(const std::string& text);

// The unit that an object says its lengths are in: "unit": "cm". Nothing when it says none, and when its type has such
// a field itself.
std::optional<LengthUnit> UnitOf(const nlohmann::json& object, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
