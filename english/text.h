// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences as words, numbers and signs, each with its bytes of the text.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flair::english {

// A length as a sentence states it, metres. "At least 0.6 m" has only a least value, "0.3 to 1 m" both, a plain "0.4 m"
// both and `exact`.
struct Length {
  std::optional<double> min_m;
  std::optional<double> max_m;
  bool exact = false;

  // The one figure that stands for it: the least value when there is one.
  double Nominal() const { return min_m ? *min_m : max_m.value_or(0); }
};

struct Token {
  enum class Kind { kWord, kNumber, kLength, kSign };
  Kind kind = Kind::kSign;
  // Lower case; a possessive ending is the word "'s". Empty for lengths.
  std::string text;
  double number = 0;  // of kNumber
  Length length;      // of kLength, see JoinLengths
  // Bytes [begin, end) of the text.
  size_t begin = 0;
  size_t end = 0;
  // No space stands before it.
  bool glued = false;

  bool IsWord(std::string_view word) const { return kind == Kind::kWord && text == word; }
  bool IsMark(char mark) const { return kind == Kind::kSign && text[0] == mark; }
};

bool IsOneOf(const Token& token, std::initializer_list<std::string_view> words);

// Whether it is a word of that list of Language::Get().
bool IsIn(std::string_view list, const Token& token);

// Splits any bytes, in linear time; never fails. Words are letters, also beyond ASCII (é, è, ê become e); every other
// printable ASCII character is a sign. Typographic quotes, dashes, primes, fractions and crosses become their plain
// forms: "½" is the number 0.5. "Doesn't" is "does" "not", "it's" is "it" "is", "the bed's" is "the" "bed" "'s". A
// comma before three digits groups thousands, any other comma between digits is a decimal point. Number words stay
// words, see quantities.h.
std::vector<Token> Tokenize(std::string_view text);

// Of all signs only those that divide sentences: every end of a sentence is ".", a dash between words is ",", hyphens
// within words and quotation marks go, "&" is "and", foot and inch marks are words. What remains is one of . , : ( ) /
// ~ and "-" before a number.
std::vector<Token> KeepClauseMarks(const std::vector<Token>& tokens);

}  // namespace flair::english
