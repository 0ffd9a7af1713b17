// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"
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

// "Five desks, one stool at each", "three guests, each with a microphone": as many as of what was counted before. Words in
// `used` belong to something else.
bool IsOneForEach(const std::vector<Token>& tokens, const std::vector<bool>& used, std::size_t i, std::size_t length);

// The index of the number in "for eight", "seating twelve", "laid for one" that begins there; 0 for none.
std::size_t SeatsNumberAt(const std::vector<Token>& tokens, std::size_t i);

// Of "a table for eight", "a table for 8 people": eight. 0 when nothing of the kind stands there.
int SeatsAfter(const std::vector<Token>& tokens, std::size_t i);

// Where a phrase of a list begins among the words for the looks of the noun at `i`: "a wall-mounted flat screen".
std::optional<std::size_t> PhraseBefore(std::string_view list, const std::vector<Token>& tokens, std::size_t i);

bool IsArticle(std::string_view word);

// "no tv", "without a desk", "no tv or desk", "a shower instead of a bathtub"; not "not near the bed", "no more than
// two chairs".
bool IsRefused(const std::vector<Token>& tokens, std::size_t i);

// A word alone refuses all of its kind: "no chairs" also the armchairs, "no lamps" those on tables and floor. Whether
// there are any.
bool RefuseKind(const Handbook& handbook, const std::vector<Token>& tokens, std::size_t i, BriefFacts& facts);

// "a bench if there is room", "perhaps a bench", "an optional bench". Words in `used` belong to something else.
bool IsOptional(const std::vector<Token>& tokens, const std::vector<bool>& used, std::size_t begin, std::size_t end);

// "only a bed and a wardrobe", "just a desk", "nothing but a sofa", "and nothing else".
bool AsksForNothingElse(const Handbook& handbook, const std::vector<Token>& tokens);

// "chair" of "dining chair".
std::string LastWord(const std::string& name);

// The class of the seats that come with a piece; null when none do.
const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook);

// Whether a class usually stands at, on or beside the other.
bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner);

// Whether one sits on it, at something: chairs and stools, not armchairs.
bool IsSeat(const hb::Furniture& furniture);

}  // namespace flair::language
