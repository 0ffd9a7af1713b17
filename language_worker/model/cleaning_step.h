// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/fault.h"

namespace flair::language {

// Step D iii: the handbook's cleaning, then the model's of what is left; the model names changes, all else stays.
// Tertiaries' sentences are not sent: each says one thing. Asks nothing when there is no other. Errors as
// Conversation::Ask.
absl::StatusOr<v1::ConstraintList> AskCleaning(const v1::Room& room, const v1::ObjectList& objects,
                                               const v1::ConstraintList& raw, const ModelTools& tools,
                                               llm::Conversation& conversation);

// What is wrong with an answer that reads well: changes that do not do what they are called, sentences changed twice.
std::vector<llm::Fault> CheckCleaning(const v1::ConstraintList& list, const model::v1::CleaningAnswer& answer);

// The list after the changes of an answer from which what was wrong has been left out.
v1::ConstraintList ApplyCleaning(const v1::ConstraintList& list, const model::v1::CleaningAnswer& answer,
                                 const ObjectWords& words);

// Sentences by id: those that a cleaning may change. Borrows the list.
using SentenceIndex = std::map<std::string, const v1::Sentence*, std::less<>>;
SentenceIndex IndexOf(const v1::ConstraintList& list);

// Some sentences and what takes their place: one of several, several of one, or nothing.
struct Change {
  std::vector<std::string> from;
  std::vector<std::string> to;
  // Why they go; may be empty.
  std::string reason;
};

// The changes of an answer, in its order; lines about the same sentence are one change, and one that leaves its
// sentence as it is is none. Others that make no sense are left out, with a fault of their element in `faults` when it
// is not null: ids that there are not, sentences changed twice, several made of several. Takes any answer.
std::vector<Change> ReadChanges(const model::v1::CleaningAnswer& answer, const SentenceIndex& sentences,
                                std::vector<llm::Fault>* faults);

// Sentences that go without another in their place.
size_t RemovedCount(const std::vector<Change>& changes);

}  // namespace flair::language
