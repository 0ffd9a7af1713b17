// SPDX-License-Identifier: GPL-3.0-or-later
// How many pieces a brief means that asks for a wall of them: "bookcases along both side walls".
#pragma once

#include <cstddef>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// How many of a class, named in the plural before token `end`, stand along the walls that are told behind it: most of
// each wall, as long as they leave the floor free. 0 where no wall is told, or for what stands at none. `facts` must
// know the kind of room, and its size if the brief says it.
int CountAlongWalls(const BriefText& text, const hb::Furniture& furniture, std::size_t end, const BriefFacts& facts);

}  // namespace flair::language
