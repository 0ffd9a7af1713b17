// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/model/object_words.h"

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

}  // namespace flair::language
