// SPDX-License-Identifier: GPL-3.0-or-later
// What is settled of a place once it is known whose it is: which wall or corner, how many pieces, how far.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/place_parties.h"
#include "language_worker/handbook/reading/place_patterns.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// "On three walls", "along both long walls", "on the north and east walls": over how many the words [begin, end) share
// the pieces out.
int WallsIn(const BriefText& text, std::size_t begin, std::size_t end);

// "A chest at the foot of each bed": as many as there are beds; in each corner, as many as there are corners; 0 where
// the words tell no number.
int OneForEach(const Reading& reading, const Place& place, std::size_t begin, std::size_t end);

// "A nightstand with a lamp at each side": the piece that the one of mention `m` carries, or that carries it; null for
// none.
const hb::Furniture* ComesWith(const BriefText& text, const std::vector<Mention>& mentions, std::size_t m);
bool IsPartOfTheRoom(const Landmark& landmark);

// Small things, and what shares a worktop: the place of one is that of all in a list.
bool GoesAlong(const hb::Furniture& furniture, Landmark::Kind kind);

// "A table with a lamp on it by the window", "a bath with a ramp along the back wall": where a thing that comes with
// another one is told to be in the room, that one is; but "a bed with a bench at the foot of it".
bool IsOfTheHolder(const PlacePatterns::Match& match, const hb::Furniture& held, const hb::Furniture& holder);

// "The TV opposite the window": what it comes with stands there. On a wall it hangs, but for one of a list.
void TakeStand(const Reading& reading, const PlacePatterns::Match& match, const hb::Furniture*& piece);

// "Our books along the wall": what holds such things stands there, and is wished for. The piece itself elsewhere.
const hb::Furniture* StorageAlong(const Reading& reading, std::size_t i, const hb::AskedPlace& asked,
                                  const hb::Furniture& piece);

// The front is what they look at.
std::string SeenByAnAudience(std::string side);

// "The teacher's desk front left"; "Opposite, a drying rack": along `across`, the wall across from the last one.
std::optional<PlacePatterns::Match> PlaceByItself(const BriefText& text, std::size_t i, const PlacePatterns& patterns,
                                                  const std::string& across);

// "A wide window with a radiator below it": `it` in the words of a place, which begin at `i`, is the window where that
// was named last before the piece of mention `m`, and not to tell a place itself.
void TakeWindowForIt(const BriefText& text, const PlacePatterns& patterns, const std::vector<Mention>& mentions,
                     std::size_t m, std::size_t i, PlacePatterns::Match& match);

// "Two windows with a desk between them": in the middle of their wall. [begin, end) are the words of the place, the
// sentence begins at `before`. False where they speak of no windows.
bool PutBetweenWindows(const BriefText& text, const PlacePatterns& patterns, std::size_t before, std::size_t begin,
                       std::size_t end, Place& place, OpeningWishes& openings);

// "At least 1.5 m apart", "space behind it of 90 cm": the length told right before or behind the words, then used.
std::optional<double> LengthBeside(const Reading& reading, std::size_t begin, std::size_t end);

// "A TV opposite the window": what belongs to a wall stands against that across from it. "Armchairs facing south" look
// at the window there, else stand against the wall across. `looks`: it is told by where one looks.
void TakeWallAcross(const PlacePatterns& patterns, Landmark::Kind kind, bool looks, const OpeningWishes& openings,
                    Place& place);

// "In each corner" is of all of them; "in the opposite corner" of the corner, or two walls, of the piece before.
void TakeCorner(Landmark::Kind kind, BriefFacts& facts, Place& place);

// Directions that the sentence does not have: of "to the left of the window" only "near the window" is left.
void NoteLoosely(const Reading& reading, const Place& place, std::size_t begin, std::size_t end);

// "Two beds side by side with a nightstand between" are not flush.
void DropRowsAround(std::vector<Place>& places);

// Parts of the room that the brief names with what stands there. Linear in the number of tokens.
std::vector<NamedArea> AreasIn(const BriefText& text, const std::vector<Mention>& mentions, const MentionList& named);

// Adds places for what has none of its own, once all others are read: by the main piece of its area, or by what it
// comes with.
void StandTogether(const Reading& reading, const std::vector<Mention>& mentions, const MentionList& named,
                   const std::vector<NamedArea>& areas, const PlacePatterns& patterns);

}  // namespace flair::language
