// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "llm/answers/choices.h"

namespace flair::llm {

// The elements that a value means for a list: those of a list; one element alone; lines (answer_lines); several choices
// in one text; of messages also the members of an object, or of lists in it, whose names go where an element says
// nothing of its own: into a field that may take the name as a choice, else into the first text ("double bed": {...},
// "sleeping": [{...}]). Texts by name fill the first two fields. A text may hold any of it as JSON, or texts in lines.
nlohmann::json ElementsOf(const nlohmann::json& value, const google::protobuf::FieldDescriptor& list,
                          const FieldChoices& choices);

// What an object without a member for a list of messages has for it under the names of its elements' choices, as an
// object of these members: "doors" and "windows" for openings that are a door or a window. Null for nothing.
nlohmann::json MembersByChoice(const nlohmann::json& object, const google::protobuf::FieldDescriptor& list,
                               const FieldChoices& choices);

// The object that a text means for a message: its JSON; or, for a name and a text about it, both around a colon or
// dash: "sleeping: bed and nightstands". Null for none.
nlohmann::json ObjectOfText(const std::string& text, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
