// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "translator_worker/grammar/distance.h"

namespace flair::translator {

// One piece of a sentence: a lower-case word, a number, a length, or one punctuation character.
struct Token {
  enum class Kind { kWord, kNumber, kDistance, kPunctuation };
  Kind kind = Kind::kWord;
  // Lower case; "'s" for a possessive ending. Empty for lengths.
  std::string text;
  double number = 0;
  Distance distance;
  // Bytes [begin, end) of the sentence.
  size_t begin = 0;
  size_t end = 0;

  bool IsWord(std::string_view word) const { return kind == Kind::kWord && text == word; }
  bool IsMark(char mark) const { return kind == Kind::kPunctuation && text[0] == mark; }
};

// Splits any bytes into tokens, in linear time; never fails. Typographic quotes, dashes and fractions become their
// plain forms, "doesn't" becomes "does" "not", other characters outside ASCII separate words. Lengths are not joined
// yet, see JoinQuantities.
std::vector<Token> Tokenize(std::string_view text);

bool IsOneOf(const Token& token, std::initializer_list<std::string_view> words);

}  // namespace flair::translator
