// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// A kind of room where a brief names it.
struct NamedRoom {
  const hb::Archetype* archetype = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
};

// What a brief says that the room is.
struct RoomKind {
  NamedRoom room;                 // `archetype` is null where none is named
  std::vector<NamedRoom> also;    // the same room is these, too: "open plan kitchen/living/dining"
  std::vector<NamedRoom> named;   // others that it has: "a bedroom with a home office and ensuite"
  std::vector<NamedRoom> placed;  // with the words for where in the room it lies: "kitchen at the east end"
};

// Reads it. What comes before "with" is the room, what comes after is in it; of several the longest name counts, then
// the first. Rooms that serve another ("en suite") are that only when no other is named. Linear in the text.
RoomKind ReadRoomKind(const std::vector<Token>& tokens, const Handbook& handbook);

// The kind that most words of the brief hint at; null when none does.
const hb::Archetype* MostHintedAt(const Handbook& handbook, const std::vector<Token>& tokens);

// The kind that most of the pieces that are named belong to, the first of them above all: of "a trestle table with two
// benches" a dining room. The fallback when they are no kind's.
const hb::Archetype& KindOfPieces(const Handbook& handbook, const std::vector<Token>& tokens);

}  // namespace flair::language
