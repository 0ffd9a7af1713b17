// SPDX-License-Identifier: GPL-3.0-or-later
// What is answered to a sentence, in plain English.
#pragma once

#include <string>
#include <vector>

#include "session/sentences/pieces_meant.h"

namespace flair::session {

// "the wall clock", "dining chair 2", "the 4 dining chairs", "the sofa and the rug".
std::string TheOnes(const v1::SolvedLayout& layout, const ObjectIds& ids);
// "the sofa or the desk", "a, b and c".
std::string Listed(const std::vector<std::string>& words, const std::string& join);
std::string Capital(std::string text);

// " The desk and the rug moved too.", of what moved and is not in `about`; empty when nothing did.
std::string MovedToo(const v1::SolvedLayout& layout, const ObjectIds& moved_ids, const IdSet& about);

// The first fault that is new.
std::string NewFault(const v1::SolvedLayout& before, const v1::SolvedLayout& after);
// What stands worse than before of these, as " But ...": faults that are new. Empty for none.
std::string AtACost(const v1::SolvedLayout& before, const v1::SolvedLayout& after, const IdSet& about);

// What an act has spoiled that an answer does not tell yet: the way through the room, fronts, doors, and new faults, as
// " But ...". `remarks`: those of the act.
std::string HarmDone(const v1::SolvedLayout& before, const v1::SolvedLayout& after,
                     const std::vector<v1::Diagnostic>& remarks, const std::string& answer);

// What can be said in this room instead of a text: an example of its verb with the pieces that it names; without a verb
// two with pieces of the room, others at every turn.
std::string Examples(const std::string& text, const v1::SolvedLayout& layout, unsigned turn);

// The first word of a text that means nothing here; empty when all are known.
std::string UnknownWord(const std::string& text, const v1::SolvedLayout& layout, const FindPiece& find);

}  // namespace flair::session
