// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "language_worker/handbook/reading/sayings.h"
#include "language_worker/handbook/reading/speller.h"

namespace flair::language {

// The words that briefs may use for pieces, made once for a handbook: the same in every kind of room.
struct Vocabulary {
  // A noun for several classes, with the words before it that tell which.
  struct Head {
    struct Modifier {
      Phrase words;
      const hb::Furniture* furniture;
    };
    const hb::Noun* noun;
    std::vector<Phrase> words;
    std::vector<const hb::Furniture*> options;
    std::vector<Modifier> modifiers;
  };

  // `handbook` must outlive it and have its look-up tables.
  explicit Vocabulary(const Handbook& handbook);

  std::vector<Saying<hb::Furniture>> names;  // every word that names a class, words for several of them first
  std::vector<Head> heads;
  std::vector<Phrase> other_things;
  Speller speller;
};

}  // namespace flair::language
