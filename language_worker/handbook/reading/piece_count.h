// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

inline constexpr int kMostSeats = 40;  // at one piece

// How many of a piece a brief asks for.
struct PieceCount {
  int number = 1;
  bool said = true;  // false: a plural without a number
};

// The number said before a noun of `length` tokens at `i`, looking back over adjectives: "two comfortable armchairs",
// "2 x desk", "a pair of". A plural without one means two at least.
PieceCount CountBefore(const Handbook& handbook, const std::vector<Token>& tokens, const hb::Furniture& furniture,
                       std::size_t i, std::size_t length);

// Of "two rows of five benches" and "mats in 3 rows of 4" the number in all and the words that say it.
struct Rows {
  int number = 0;  // 0 where no rows are counted
  std::size_t begin = 0;
  std::size_t end = 0;
};
Rows RowsAround(const std::vector<Token>& tokens, std::size_t i, std::size_t length);

// "another desk", "a second desk": one more than were asked for before.
bool IsFurther(const std::vector<Token>& tokens, std::size_t i);

// "not too many plants", "hardly any cushions", "few pictures": one at most. "A few" are some.
bool AsksForFew(const std::vector<Token>& tokens, std::size_t i);

// The "poster" of "four-poster" is no picture.
bool IsMeasure(const std::vector<Token>& tokens, std::size_t i);

// "for eight", "with six chairs": behind a word for a table, those who sit at it.
bool SeatsFollow(const std::vector<Token>& tokens, std::size_t i);

// Of "a table for eight", "a table for 8 people": eight. 0 when nothing of the kind stands there.
int SeatsAfter(const std::vector<Token>& tokens, std::size_t i);

bool IsArticle(std::string_view word);

}  // namespace flair::language
