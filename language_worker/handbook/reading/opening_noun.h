// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "language_worker/handbook/reading/opening_wish.h"
#include "language_worker/handbook/reading/opening_words.h"

namespace flair::language {

// The words that name an opening: "two large sliding doors to the garden, 1.8 m wide".
struct OpeningNoun {
  enum class Kind { kNone, kOpening, kOverhead };
  Kind kind = Kind::kNone;
  OpeningWish wish;
  bool none = false;     // "no windows"
  bool any = false;      // "each window", "any window": no particular one
  bool related = false;  // "under the window": it tells where something else is
  bool part = false;     // "one window", "the other window": perhaps of several that were named before
  bool bare = false;     // neither article nor number
  std::size_t begin = 0;
  std::size_t noun = 0;  // its head
  std::size_t end = 0;
};

// Reads the opening whose head is at a token; of kind kNone where there is none, or where the word belongs to a name in
// `things` ("window seat", "a wardrobe with sliding doors"). Looks at a bounded number of tokens.
OpeningNoun OpeningNounAt(const OpeningWords& words, const std::vector<bool>& things, std::size_t i);

// What stands behind a head and tells of the opening itself: where it leads, its measures, how it opens. The index
// behind that, or `i`.
std::size_t ReadMeasures(const OpeningWords& words, std::size_t i, OpeningWish& wish);

}  // namespace flair::language
