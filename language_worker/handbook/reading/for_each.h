// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of which there is one for each of several: "each needs his own bed and desk", "two groups of armchairs, each
// with a table", "one stool at each", "a locker per child"; and walls of them: "bookcases along both side walls".
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// How many have one of the piece in tokens [begin, end); 1 where nothing is said of each. `mentions` and `wishes` are
// what was named before it, `people` those whom the brief counts, 0 when it counts none. Words in `used` belong to
// something else.
int TimesForEach(const BriefText& text, const std::vector<bool>& used, std::size_t begin, std::size_t end,
                 const std::vector<Mention>& mentions, const std::vector<Wish>& wishes, int people);

// How many of a class, named in the plural before token `end`, stand along the walls that are told behind it: most of
// each wall, as long as they leave the floor free. 0 where no wall is told, or for what stands at none. `facts` must
// know the kind of room, and its size if the brief says it.
int CountAlongWalls(const BriefText& text, const hb::Furniture& furniture, std::size_t end, const BriefFacts& facts);

}  // namespace flair::language
