// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

// Where a brief names a piece.
struct Mention {
  const hb::Furniture* furniture = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
  int count = 1;
  int which = -1;      // "another desk": the second; -1 for all of them
  bool seats = false;  // said of the seats of the piece: "tables, each with two chairs"
};

// Reads where the brief wants its pieces: which piece, how, and by what ("a lamp between them"). To be called when all
// other words that may name a place have been used. Places that it finds words for and cannot read go into
// `facts.places_not_known`. Marks the tokens that it has used. `mentions` are in the order of the text.
void ReadPlaces(const Reading& reading, const std::vector<Mention>& mentions);

}  // namespace flair::language
