// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "language_worker/handbook/reading/opening_noun.h"
#include "language_worker/handbook/reading/opening_site.h"
#include "language_worker/handbook/reading/opening_wish.h"
#include "language_worker/handbook/reading/opening_words.h"

namespace flair::language {

// The openings that a brief has asked for so far: joins what it says twice of the same one, and finds the walls that go
// by other openings. The arguments must outlive it.
class OpeningList {
 public:
  OpeningList(const OpeningWords& words, OpeningWishes& openings) : words_(words), openings_(openings) {}

  void Add(const OpeningWish& wish);
  // One wish for each wall that was named.
  void AddOnSides(const OpeningNoun& noun, const OpeningSite& site);

  // To be called when all is read. A door by its relation to the windows; these have a wall of their own then.
  void SettleRelations();
  void SettleContradictions();

 private:
  std::string Resolved(const std::string& side, bool door) const;
  void Join(const OpeningNoun& noun, const OpeningSite& site, OpeningWish& wish);

  const OpeningWords& words_;
  OpeningWishes& openings_;
};

}  // namespace flair::language
