// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "translator_worker/grammar/term.h"

namespace flair::translator {

// What a pattern bound. Pointers into the terms; null where an optional part was left out.
struct Match {
  const Mention* a = nullptr;
  const Mention* b = nullptr;
  const Mention* c = nullptr;
  const Distance* distance = nullptr;
  // How many terms were covered; 0 when the pattern does not match.
  size_t length = 0;
};

// The form of a fact, such as "A? not? near B ,? D?". Elements, separated by spaces:
//   A B C     a noun phrase, bound; A is what the fact moves, B and C what it is related to
//   A.wall    only one that refers to that: object (also zones and absent things), thing (no zones),
//             wall, feature, ceiling, room, floor, zone, group, vague, pronoun; side: with a side named; list: several
//             objects
//   D         a length, bound
//   ,         a comma, "and", "with"
//   word      that lemma of the lexicon; word/word is either
//   x?        x may be left out
class Pattern {
 public:
  explicit Pattern(std::string_view text);

  // The longest match that begins at the first term.
  Match At(std::span<const Term> terms) const;

  // The choices of lemmas of which one each must be among the terms for a match.
  std::vector<std::vector<std::string>> RequiredWords() const;

 private:
  struct Element {
    char slot = 0;  // 'A', 'B', 'C', 'D', ',' or 0 for a word
    std::string sort;
    std::vector<std::string> words;
    bool optional = false;
  };

  bool Fits(const Element& element, const Term& term) const;
  void Step(std::span<const Term> terms, size_t at, size_t element, Match match, Match& best) const;

  std::vector<Element> elements_;
};

}  // namespace flair::translator
