// SPDX-License-Identifier: GPL-3.0-or-later
// Words that name a piece where nobody asks for one: what another piece holds, what passes by, rooms next
// door, parts, verbs, shapes.
#pragma once

#include <cstddef>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// A verb before what a room has, "the office showcases a desk", or a shape: the boat of a boat-shaped table, the
// columns of columns of desks.
bool IsNoNoun(const BriefText& text, std::size_t i);

// Whether the piece is only spoken of: what another one is made to hold, what passes by, what people bear or bring.
bool IsOnlyTold(const BriefText& text, const hb::Furniture& furniture, std::size_t i, std::size_t length);

// Whether the word at a token is that for a room behind a door which the brief names: "the closet door", then "near the
// closet", where that door is.
bool IsBehindADoor(const BriefText& text, std::size_t i);

// "Wheel truing station", "doll's house maker", "in camera view": what is named in [begin, end) only says of what kind
// another thing is.
bool MakesACompound(const BriefText& text, std::size_t begin, std::size_t end);

// Where words for a part of the piece before `end` stop: "with sliding doors", "on castors"; else `end`.
std::size_t BehindParts(const BriefText& text, std::size_t end);

// "Hooks for hats", "a desk for writing letters": small things by which another piece's use is told.
bool IsOfAPurpose(const BriefText& text, std::size_t i);

}  // namespace flair::language
