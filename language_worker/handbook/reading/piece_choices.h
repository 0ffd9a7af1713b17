// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the pieces that a brief names are to be in the room.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"

namespace flair::language {

// "Staff at the desk in the hall", "the freezer in the garage": what stands behind the words that end there is in
// another room. `facts` must know the kind of room.
bool IsInAnotherRoom(const Reading& reading, std::size_t end);

// "The furnace room door", "a bar door"; the door of a cupboard is the cupboard's.
bool IsBehindItsDoor(const Reading& reading, std::size_t begin, std::size_t end);

// "A double vanity, ..., oak vanity": behind words for its looks alone, one that was asked for before.
std::optional<Mention> NamedAgainByItsLook(const Reading& reading, const hb::Furniture& furniture, std::size_t i,
                                           std::size_t length);

// "A table for four or an island": keeps of two pieces the one whose condition holds, "if there is space", else the
// first, and takes the other one as refused.
void ChooseOne(const Reading& reading, std::vector<Mention>& mentions);

// "A dresser that doubles as a changing table": whether the piece named at a token is the last one of the mentions,
// too, which `facts` then say.
bool IsTheLastAsWell(const Reading& reading, std::vector<Mention>& mentions, const hb::Furniture& named, std::size_t i);

}  // namespace flair::language
