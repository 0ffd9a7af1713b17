// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces that a brief speaks of before it asks for them, "... on the left of the bed. Hospital bed 100 x 210 ...", and
// once more later.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/noun_book.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// What was spoken of by a word for several classes and is named later is that one: drops the wish for the vague one,
// and its mentions are of the other. `mentions` and `facts` are those of the whole text.
void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions);

// "... a coffee table. The table should be round", "in front of sofa", "opposite the tub": the piece that was asked for
// before and that the words at token `i` speak of once more, or the seats of one. Nothing where they ask for another
// one.
std::optional<Mention> MeantBefore(const BriefText& text, std::size_t i, std::size_t length, const NounBook& nouns,
                                   const BriefFacts& facts, const Handbook& handbook);

}  // namespace flair::language
