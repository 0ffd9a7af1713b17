// SPDX-License-Identifier: GPL-3.0-or-later
// A brief's words, and phrases found among them. Lists of words are those of english/data/en/briefs.textproto, asked
// for by their names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "english/text.h"

namespace flair::language {

using english::Token;

// The tokens of a text. Number words from thirteen on are numbers, as if written in digits. Linear in its length.
std::vector<Token> TokensOf(std::string_view text);

// "one" to "twelve", "a", "an", "both", "pair" and the like; nothing for other words.
std::optional<int> NumberWord(std::string_view word);

// Whether two words are forms of one noun; a `base` that ends in '*' stands for any ending.
bool MatchesWord(std::string_view word, std::string_view base);

// Whether the list of that name has the word, or a form of it.
bool IsIn(std::string_view list, std::string_view word);
bool IsFormIn(std::string_view list, std::string_view word);
inline bool IsOneOf(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

// Whether a list has an item.
template <typename List, typename Item>
bool Includes(const List& list, const Item& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
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
  std::vector<int> numbers_;  // of each word, 0 where it says none
};

// The words of the list of that name, in its order, and the same as phrases.
const std::vector<std::string>& WordsOf(std::string_view list);
const std::vector<Phrase>& PhrasesOf(std::string_view list);

// Marks tokens [begin, end), as far as there are such.
inline void Mark(std::size_t begin, std::size_t end, std::vector<bool>& tokens) {
  for (std::size_t i = begin; i < std::min(end, tokens.size()); ++i) tokens[i] = true;
}

// Tokens as readers look at them: beyond the end there are empty words. The tokens must outlive it.
class BriefText {
 public:
  explicit BriefText(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::size_t size() const { return tokens_.size(); }
  const std::vector<Token>& tokens() const { return tokens_; }
  std::string_view At(std::size_t i) const { return i < size() ? std::string_view(tokens_[i].text) : ""; }
  bool IsSign(std::size_t i) const { return i < size() && tokens_[i].kind == Token::Kind::kSign; }
  bool IsNumber(std::size_t i) const { return i < size() && tokens_[i].kind == Token::Kind::kNumber; }
  bool IsWord(std::size_t i) const { return i < size() && tokens_[i].kind == Token::Kind::kWord; }
  double NumberAt(std::size_t i) const { return i < size() ? tokens_[i].number : 0; }
  bool IsHyphen(std::size_t i) const { return IsSign(i) && At(i) == "-" && tokens_[i].glued; }  // within a word
  bool EndsSentence(std::size_t i) const { return i >= size() || (IsSign(i) && IsOneOf(At(i), {".", ";", "!", "?"})); }

  // Whether the word there is in the list of that name, or one of these.
  bool Is(std::size_t i, std::string_view list) const { return i < size() && IsIn(list, At(i)); }
  bool Says(std::size_t i, std::initializer_list<std::string_view> words) const {
    return i < size() && IsOneOf(At(i), words);
  }

  // The index behind a phrase that stands there, hyphens passed over; nothing when it does not.
  std::optional<std::size_t> Behind(std::size_t i, std::string_view phrase) const;
  // The index behind the longest phrase of a list that stands there.
  std::optional<std::size_t> BehindPhrase(std::size_t i, std::string_view list) const;
  // Behind the words "the", "a", "your" and the like, if any.
  std::size_t BehindArticle(std::size_t i) const { return Is(i, "articles") ? i + 1 : i; }

  // Where the noun phrase begins whose noun stands at `noun`: over its looks, its number, "a pair of" and its article.
  std::size_t PhraseBegin(std::size_t noun) const;

  // A length with its unit, metres, which begins at a number: "1.2 m", "90cm", "3 ft", "4'"; `end` is behind it.
  std::optional<double> LengthAt(std::size_t i, std::size_t& end) const;

  std::string Quote(std::size_t begin, std::size_t end) const;

 private:
  const std::vector<Token>& tokens_;
};

}  // namespace flair::language
