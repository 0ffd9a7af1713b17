// SPDX-License-Identifier: GPL-3.0-or-later
// What a model changed when it cleaned a list of constraints and wrote the whole list again.
#pragma once

#include <vector>

#include "flair/model/v1/constraint_answers.pb.h"
#include "language_worker/recorded/constraint_text.h"
#include "language_worker/recorded/prompt_lines.h"

namespace flair::language {

// The changes that make of `before` what the model's `after` says, found by the sentences' objects and words: the same
// words stay, other words for it simplify, several for one split, and what has no counterpart is removed, but not more
// than half of all: then what could not be recognised is more than what was removed. `names` are the objects' names.
model::v1::CleaningAnswer FindChanges(const std::vector<PromptSentence>& before,
                                      const std::vector<RecordedSentence>& after,
                                      const std::vector<std::string>& names);

}  // namespace flair::language
