// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json.hpp>

namespace flair::llm {

// The object that a value means for an answer of that type: itself when it has any of the type's fields; the only such
// object in it, when it is a wrapper, as "{"answer": {...}}" and "[{...}]" are, also with its JSON as a text; else a
// list of the type's, when it is elements of that: a list alone, one element alone, elements by name, a list beside
// remarks. Else the value itself.
nlohmann::json AnswerRoot(nlohmann::json value, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
