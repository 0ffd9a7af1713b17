// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/place_reader.h"

namespace flair::language {

// What ReadFurniture found, in the order of the text.
struct NamedPieces {
  std::vector<Mention> mentions;
  std::vector<std::size_t> counts;  // tokens: the numbers and denials that belong to pieces
};

// Reads the pieces that a brief asks for and refuses, how many of them, who sits at them and in what colour. Marks the
// tokens that it has used, but for the counts. `facts` must know the kind of room, and its size if the brief says it: a
// word for several classes ("chair", "bench") means the one that belongs there.
NamedPieces ReadFurniture(const Reading& reading);

}  // namespace flair::language
