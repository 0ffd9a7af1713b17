// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// The tokens of a brief as the readers of openings look at them: beyond the end there are empty words.
class OpeningWords {
 public:
  explicit OpeningWords(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::size_t size() const { return tokens_.size(); }
  std::string_view At(std::size_t i) const;
  bool IsSign(std::size_t i) const;
  bool IsNumber(std::size_t i) const;
  double NumberAt(std::size_t i) const;
  bool IsHyphen(std::size_t i) const;  // within a word
  bool EndsSentence(std::size_t i) const;

  // Words that stand there one after another, hyphens passed over; the index behind them, nothing when they do not.
  std::optional<std::size_t> Behind(std::size_t i, std::string_view phrase) const;
  // Behind the first of the phrases, separated by '|', that stands there.
  std::optional<std::size_t> BehindOneOf(std::size_t i, std::string_view phrases) const;
  // Behind the words "the", "a", "your" and the like, if any.
  std::size_t BehindArticle(std::size_t i) const;

  // A length with its unit, metres, which begins at a token: "1.2 m", "90cm", "3 ft", "4'"; `end` is behind it.
  std::optional<double> LengthAt(std::size_t i, std::size_t& end) const;

  std::string Quote(std::size_t begin, std::size_t end) const;

 private:
  const std::vector<Token>& tokens_;
};

// Whether a word is one of those in a list separated by spaces.
bool IsAmong(std::string_view words, std::string_view word);

}  // namespace flair::language
