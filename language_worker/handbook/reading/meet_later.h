// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that a brief speaks of before it asks for them: "... on the left of the bed. Hospital bed 100 x 210 ...".
#pragma once

#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// What was spoken of by a word for several classes and is named later is that one: drops the wish for the vague one,
// and its mentions are of the other. `mentions` and `facts` are those of the whole text.
void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions);

}  // namespace flair::language
