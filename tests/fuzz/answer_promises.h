// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold of every answer of a model that was read, whatever its bytes were.
#pragma once

#include <google/protobuf/message.h>

#include <span>

#include "llm/answers/choices.h"
#include "llm/answers/fault.h"

namespace flair::fuzz {

// Every fault says where it is, in fields that there are, and what is wrong, in text that may go into a log or a
// prompt.
void CheckFaults(std::span<const llm::Fault> faults, const google::protobuf::Descriptor& type);

// No list is longer than it may be.
void CheckLists(const google::protobuf::Message& answer);

// An answer that nothing wrong is left in: numbers finite and in their range, texts on one line, no longer than they
// may be, and among the choices where there are some.
void CheckUseful(const google::protobuf::Message& answer, const llm::FieldChoices& choices);

// The same, written as JSON and read again, is the same answer.
void CheckReadsTheSame(const google::protobuf::Message& answer, const llm::FieldChoices& choices);

// What a repair of single elements is asked with is JSON, and an answer to it changes these elements alone.
void CheckPartialRepair(std::string_view text, std::span<const llm::Fault> faults,
                        const google::protobuf::Message& answer, const llm::FieldChoices& choices);

}  // namespace flair::fuzz
