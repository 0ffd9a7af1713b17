// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of pieces that a brief wants several times: "two working stations, each with a chair, a stool and a lamp".
#pragma once

#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// Finds them in the text, before its furniture is read, and marks the words for what is no piece itself.
void ReadSets(const Reading& reading);

// The set that lists what stands at a token; null where none does.
NamedSet* SetAt(std::size_t i, BriefFacts& facts);

}  // namespace flair::language
