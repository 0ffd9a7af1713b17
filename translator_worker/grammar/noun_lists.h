// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "translator_worker/grammar/noun_phrases.h"

namespace flair::translator {

// Joins lists of noun phrases to one mention each: "the bed, the wardrobe and the desk". What is not joined becomes a
// soft break ("and") or the word "or"; modal verbs go.
std::vector<Term> JoinLists(std::vector<RawTerm> raw);

}  // namespace flair::translator
