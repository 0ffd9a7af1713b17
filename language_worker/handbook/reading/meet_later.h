// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that a brief speaks of before it asks for them: "... on the left of the bed. Hospital bed 100 x 210 ...".
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// What was spoken of by a word for several classes and is named later is that one: drops the wish for the vague one,
// and its mentions are of the other. `mentions` and `facts` are those of the whole text.
void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions);

// "A freestanding bathtub ... opposite the tub": the wish for a class of this brief's own that the words at token `i`
// speak of once more, which name `named`; null for other words.
const Wish* NamedAgain(const BriefText& text, std::size_t i, const hb::Furniture* named, const BriefFacts& facts,
                       const Handbook& handbook);

}  // namespace flair::language
