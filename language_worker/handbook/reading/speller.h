// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// A word that was read as another one.
struct Correction {
  std::string written;
  std::string read;
};

// Whether a letter put in, left out, changed, or swapped with its neighbour makes one word the other. Equal words are
// not.
bool IsOneEditAway(std::string_view a, std::string_view b);

// Reads misspelt words of the handbook: "kichen" as kitchen, "wardorbe" as wardrobe. Only words of five letters or more
// that are no common English, and only where exactly one known word is one edit away.
class Speller {
 public:
  // Keeps nothing of `handbook`.
  explicit Speller(const hb::Handbook& handbook);

  // The word that is meant; empty when none or more than one is near, or the word is right as it is.
  std::string MeantBy(std::string_view word) const;

  // Replaces misspelt words. Linear in the number of tokens. Returns what it has replaced, each once.
  std::vector<Correction> Correct(std::vector<Token>& tokens) const;

 private:
  void Learn(std::string_view phrase, bool corrects);

  std::unordered_set<std::string> right_;  // never corrected
  // Words that others are corrected to, under their first and under their last two letters: one edit leaves one of
  // these.
  std::unordered_map<std::string, std::vector<std::string>> by_ends_;
};

}  // namespace flair::language
