// SPDX-License-Identifier: GPL-3.0-or-later
// What is settled of a place once it is known whose it is: which wall or corner, how many pieces, how far.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/place_patterns.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// "On three walls", "along both long walls", "on the north and east walls": over how many the words [begin, end) share
// the pieces out.
int WallsIn(const BriefText& text, std::size_t begin, std::size_t end);

// "A chest at the foot of each bed": as many as there are beds; in each corner, as many as there are corners; 0 where
// the words tell no number.
int OneForEach(const BriefText& text, const BriefFacts& facts, const Place& place, std::size_t begin, std::size_t end);

// "A nightstand with a lamp at each side": the piece that the one of mention `m` carries, or that carries it; null for
// none.
const hb::Furniture* ComesWith(const BriefText& text, const std::vector<Mention>& mentions, std::size_t m);

// "At least 1.5 m apart", "space behind it of 90 cm": the length told right before or behind the words, then used.
std::optional<double> LengthBeside(const BriefText& text, std::size_t begin, std::size_t end, std::vector<bool>& used);

// "A TV opposite the window": what belongs to a wall stands against that across from it.
void TakeWallAcross(const PlacePatterns& patterns, Landmark::Kind kind, Place& place);

// "In each corner" is of all of them; "in the opposite corner" of the corner, or two walls, of the piece before.
void TakeCorner(Landmark::Kind kind, BriefFacts& facts, Place& place);

// Directions that the sentence does not have: of "to the left of the window" only "near the window" is left.
void NoteLoosely(const BriefText& text, const Place& place, std::size_t begin, std::size_t end, BriefFacts& facts);

// "Two beds side by side with a nightstand between" are not flush.
void DropRowsAround(std::vector<Place>& places);

}  // namespace flair::language
