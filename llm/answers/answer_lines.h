// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "llm/answers/choices.h"

namespace flair::llm {

// A list whose elements are lines, "s1: words", as the objects that they stand for: the part before the colon is the
// type's first field, the rest the only element of its second. Marks of a list, quotes and brackets around the first
// part mean nothing. One text may hold all lines, and an object may have them by their first parts. Elements that are
// no texts stay. Pure; any value is good input.
nlohmann::json ListOfLines(const nlohmann::json& value, const google::protobuf::Descriptor& type);

// The answer that lines of an answer without any JSON mean: those of the type's only list, when that may be in lines,
// that begin with a choice of their first part, or with an id such as "s12" where it has no choices, and a colon.
// Discarded when there is none.
nlohmann::json AnswerOfLines(std::string_view answer, const google::protobuf::Descriptor& type,
                             const FieldChoices& choices);

}  // namespace flair::llm
