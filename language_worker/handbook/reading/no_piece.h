// SPDX-License-Identifier: GPL-3.0-or-later
// Words that name a piece where nobody asks for one: what another piece holds, what passes by, parts, verbs, shapes.
#pragma once

#include <cstddef>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Whether the word is a verb before what a room has: "the office showcases a desk".
bool IsAVerb(const BriefText& text, std::size_t i);

// "Wheel truing station", "doll's house maker": what is named before `end` only says of what kind another thing is.
bool MakesACompound(const BriefText& text, std::size_t end);

// The boat of a boat-shaped table, the columns of columns of desks.
bool IsAShape(const BriefText& text, std::size_t i);

// Where words for a part of the piece before `end` stop: "with sliding doors", "without a headboard"; else `end`.
std::size_t BehindParts(const BriefText& text, std::size_t end);

// "A rack for eight bikes", "a stand for his piano": what another piece is made to hold.
bool IsHeld(const BriefText& text, const hb::Furniture& furniture, std::size_t i);

// The prams of "wide enough for prams" and "so that prams can pass".
bool IsPassing(const BriefText& text, std::size_t i, std::size_t length);

// The trays of "waiters with trays".
bool IsBorne(const BriefText& text, const hb::Furniture& furniture, std::size_t i);

// The bikes of "where customers drop off bikes".
bool IsOfATale(const BriefText& text, std::size_t i);

// "Hooks for hats", "a desk for writing letters": small things by which another piece's use is told.
bool IsOfAPurpose(const BriefText& text, std::size_t i);

}  // namespace flair::language
