// SPDX-License-Identifier: GPL-3.0-or-later
// The colours and materials that a brief names for pieces: "a green armchair", "chairs charcoal", "bed in white linen",
// "matt sage fronts"; their sizes, and their names where they are others than the handbook's.
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"

namespace flair::language {

// Reads what is said before the name of a piece at token `noun`: it is the piece's, not the room's; of several
// colours and materials the first. Marks what it has used.
void TakeLooksBefore(const Reading& reading, const hb::Furniture& furniture, std::size_t noun);

// Whether "cabinets" in "cabinets in navy blue" only tells the colour of fitted furniture, as a kitchen has it, and
// asks for none.
bool AreFronts(const Reading& reading, std::size_t i);

// The same for what is said behind them, and for what is said of all fronts or all that one sits on. To be called when
// all pieces are known.
void TakeLooksBehind(const Reading& reading, const std::vector<Mention>& mentions);

// Reads the sizes of pieces; those far from what the class can be are of something else, or a slip. `taken`: tokens of
// other sizes.
void TakeSizes(const Reading& reading, const std::vector<Mention>& mentions, std::vector<bool> taken);

// What a piece is called by a word that means something else: a "flipchart" that is an easel here.
void NoteOtherNames(const BriefText& text, const std::vector<Mention>& mentions, BriefFacts& facts);

}  // namespace flair::language
