// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "english/text.h"
#include "translator_worker/grammar/noun_phrases.h"

namespace flair::translator {

// Leaves out what the condition of `length` tokens at tokens[at] ("if") holds for, and the condition: an aside that
// follows what holds anyhow, or one clause of several, whose terms are taken off `terms`. Where reading goes on;
// nothing when the whole sentence is conditional.
std::optional<size_t> LeaveOutCondition(const std::vector<Token>& tokens, size_t at, size_t length,
                                        std::vector<RawTerm>& terms);

}  // namespace flair::translator
