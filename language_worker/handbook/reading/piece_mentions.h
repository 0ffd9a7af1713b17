// SPDX-License-Identifier: GPL-3.0-or-later
// Words that name a piece where nobody asks for one, what another piece holds, what passes by, rooms next door, parts,
// verbs, shapes;
// and pieces that a brief speaks of before it asks for them, "... on the left of the bed. Hospital bed 100 x 210 ...",
// or once more later.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/noun_book.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// A verb before what a room has, "the office showcases a desk", or a shape: the boat of a boat-shaped table, the
// columns of columns of desks.
bool IsNoNoun(const BriefText& text, std::size_t i);

// Whether the piece is only spoken of: what another one is made to hold, what passes by, what people bear or bring.
bool IsOnlyTold(const BriefText& text, const hb::Furniture& furniture, std::size_t i, std::size_t length);

// "Waiters with trays", "customers come with prams and backpacks": what people bring. `small`: it stands on tops.
bool IsBorne(const BriefText& text, std::size_t i, bool small);

// Whether the word at a token is that for a room behind a door which the brief names: "the closet door", then "near the
// closet", where that door is.
bool IsBehindADoor(const BriefText& text, std::size_t i);

// "The furnace room door", "a bar door": whether a door follows at a token, named by what is behind it.
bool IsBeforeADoor(const BriefText& text, std::size_t end);

// "Wheel truing station", "doll's house maker", "in camera view": what is named in [begin, end) only says of what kind
// another thing is.
bool MakesACompound(const BriefText& text, std::size_t begin, std::size_t end);

// Where words for a part of the piece before `end` stop: "with sliding doors", "on castors"; else `end`.
std::size_t BehindParts(const BriefText& text, std::size_t end);

// "Hooks for hats", "a desk for writing letters": small things by which another piece's use is told.
bool IsOfAPurpose(const BriefText& text, std::size_t i);

// What was spoken of by a word for several classes and is named later is that one: drops the wish for the vague one,
// and its mentions are of the other. `mentions` and `facts` are those of the whole text.
void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions);

// "... a coffee table. The table should be round", "in front of sofa", "opposite the tub": the piece that was asked for
// before and that the words at token `i` speak of once more, or the seats of one. Nothing where they ask for another
// one.
std::optional<Mention> MeantBefore(const BriefText& text, std::size_t i, std::size_t length, const NounBook& nouns,
                                   const BriefFacts& facts, const Handbook& handbook);

// How many have one of the piece in tokens [begin, end); 1 where nothing is said of each. `mentions` and the wishes of
// `reading` are what was named before it, `people` those whom the brief counts, 0 when it counts none.
int TimesForEach(const Reading& reading, std::size_t begin, std::size_t end, const std::vector<Mention>& mentions,
                 int people);

// How many of a class, named in the plural before token `end`, stand along the walls that are told behind it: most of
// each wall, as long as they leave the floor free. 0 where no wall is told, or for what stands at none. `facts` must
// know the kind of room, and its size if the brief says it.
int CountAlongWalls(const BriefText& text, const hb::Furniture& furniture, std::size_t end, const BriefFacts& facts);

}  // namespace flair::language
