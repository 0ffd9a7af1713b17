// SPDX-License-Identifier: GPL-3.0-or-later
// What a sentence still tells when no rule has read a fact in it.
#pragma once

#include <vector>

#include "translator_worker/grammar/composer.h"
#include "translator_worker/grammar/term.h"

namespace flair::translator {

// "Needs enough space for sitting down (0.6 m)": space of a piece, nothing else named; where it is follows from what
// it is. False when the sentence says something else.
bool TakeSpace(const std::vector<Term>& terms, Composer& composer);

// "Needs a socket": that it is named is all that is said, and what has a use for one stands near it.
void TakeSocket(const std::vector<Term>& terms, Composer& composer);

// "Top shelf of the bookcase", "dining table centerpiece": of a small thing the one piece that is named says where it
// is. False when the sentence says something else.
bool TakePlace(const std::vector<Term>& terms, Composer& composer);

}  // namespace flair::translator
