// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>

#include "llm/answers/choices.h"

namespace flair::llm {

// The elements that a value means for a list: those of a list; one element alone; lines (answer_lines); several choices
// in one text; of messages also the members of an object, or of lists in it, whose names go where an element says
// nothing of its own: into a field that may take the name as a choice, else into the first text ("double bed": {...},
// "sleeping": [{...}]). Texts by name fill the first two fields.
nlohmann::json ElementsOf(const nlohmann::json& value, const google::protobuf::FieldDescriptor& list,
                          const FieldChoices& choices);

}  // namespace flair::llm
