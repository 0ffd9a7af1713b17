// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

// A piece of a brief: a word (letters, lower case), a number, or a single sign.
struct Token {
  enum class Kind { kWord, kNumber, kSign };
  Kind kind = Kind::kSign;
  std::string text;    // lower case; typographic quotes, primes and multiplication signs as ', " and x
  double number = 0;   // of kNumber; a comma between digits is a decimal point
  bool glued = false;  // no space before it
};

// Splits UTF-8 text. Bytes that belong to no word or number become signs. Number words from thirteen on are numbers, as
// if written in digits. Linear in the length of the text.
std::vector<Token> Tokenize(std::string_view text);

// "one" to "twelve", "a", "an", "both", "pair" and the like; nothing for other words.
std::optional<int> NumberWord(std::string_view word);

// Whether `word` is `stem`, or a plural of it in -s, -es, -ies or -ves. A stem that ends in '*' stands for any ending.
bool MatchesWord(std::string_view word, std::string_view stem);

// Whether "six WORD" counts those whom the room is for: people, guests, children ...
bool CountsPeople(std::string_view word);

// Whether a list has a word, exactly.
template <typename List>
bool IncludesWord(const List& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// Phrases looked for in a text, as words; "{n}" in a phrase matches a number.
class Phrase {
 public:
  explicit Phrase(std::string_view text);

  // Number of tokens that the phrase covers from `start` on, 0 when it does not begin there. Sets `number` for "{n}".
  // The last word may be plural when `plural` is true. One word may be written as two and two as one: "barstool".
  std::size_t MatchAt(const std::vector<Token>& tokens, std::size_t start, bool plural = true,
                      int* number = nullptr) const;

  // Whether it occurs anywhere.
  bool Occurs(const std::vector<Token>& tokens, int* number = nullptr) const;

 private:
  std::size_t MatchSpelling(const std::vector<Token>& tokens, std::size_t start, bool plural) const;

  std::vector<std::string> words_;
};

}  // namespace flair::language
