// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <string>

#include "llm/answers/choices.h"

namespace flair::llm {

// The JSON schema of an answer, compact, in the subset that servers enforce strictly: every object closed, every field
// required (those with `optional` may be null), choices as enums, numbers and lists with their limits, and the fields'
// docs as descriptions. `message` must not contain itself. Deterministic.
std::string AnswerSchema(const google::protobuf::Descriptor& message, const FieldChoices& choices);

// A name for it that the protocol accepts, such as "floor_objects_answer".
std::string AnswerSchemaName(const google::protobuf::Descriptor& message);

}  // namespace flair::llm
