// SPDX-License-Identifier: GPL-3.0-or-later
// What the words around the name of a piece say of it: how many, for how many, in which groups, and whether at all.
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

inline constexpr int kMostSeats = 40;   // at one piece
inline constexpr double kLeastCm = 60;  // numbers without a unit are lengths of a piece from there on

// How many of a piece a brief asks for.
struct PieceCount {
  int number = 1;
  bool said = true;  // false: a plural without a number
};

// The number in the phrase of a noun of `length` tokens at `i`, "two comfortable armchairs", "2 x desk", "a pair of",
// or behind it: "toadstools, five of them". A plural without one means two at least.
PieceCount CountOf(const Handbook& handbook, const BriefText& text, const hb::Furniture& furniture, std::size_t i,
                   std::size_t length);

// "Lots of plants": how many that is, nobody says.
bool SaysMany(const BriefText& text, std::size_t i);
// As many small ones of them as a floor of that area has places for.
int SensibleNumber(const hb::Furniture& furniture, double area_m2);

// Groups that a brief asks for: "two rows of five benches", "sixteen desks in four blocks of four", "in rows of 4".
struct Groups {
  int count = 0;    // 0 where it is not said
  int in_each = 0;  // 0 where it is not said
  std::size_t begin = 0;
  std::size_t end = 0;  // begin where there are none
  bool rows = false;    // side by side, not round about

  // Of so many; 0 where rows take as many as fit.
  int InEach(int number) const {
    constexpr int kUsual = 4;
    if (in_each > 0) return in_each;
    if (count > 0) return (number + count - 1) / count;
    return rows ? 0 : kUsual;
  }
};
Groups GroupsAround(const BriefText& text, std::size_t i, std::size_t length);

// "another desk", "a second desk": one more than were asked for before.
bool IsFurther(const BriefText& text, std::size_t i);

// "not too many plants", "hardly any cushions", "few pictures": one at most. "A few" are some.
bool AsksForFew(const BriefText& text, std::size_t i);

// The "poster" of "four-poster" is no picture.
bool IsMeasure(const BriefText& text, std::size_t i);

// Those who sit at a piece: "a table for eight", "tables of four", "an eight-seater table", "ten round one table", "two
// to a desk".
struct SeatsSaid {
  int number = 0;  // 0 where nothing of the kind is said
  std::size_t begin = 0;
  std::size_t end = 0;
  bool of_each = false;  // "two to a desk": how many desks there are is not said
};
SeatsSaid SeatsAround(const BriefText& text, std::size_t i, std::size_t length);

// Whether the phrase of the noun counts four or more.
bool CountsSeveral(const BriefText& text, std::size_t i);

// "for eight", "with six chairs": behind a word for a table, those who sit at it.
bool SeatsFollow(const BriefText& text, std::size_t i);

// Where a phrase of a list begins among the words for the looks of the noun at `i`: "a wall-mounted flat screen".
std::optional<std::size_t> PhraseBefore(std::string_view list, const BriefText& text, std::size_t i);

// "It should feel like a hotel", "not like a waiting room": what the room is only compared with.
bool IsLikened(const BriefText& text, std::size_t i);

// "no tv", "without a desk", "no tv or desk", "a shower instead of a bathtub"; not "not near the bed", "no more than
// two chairs", "no seats besides two chairs".
bool IsRefused(const BriefText& text, std::size_t i);

// A noun of so many tokens refuses all that it may mean, and a word alone all of its kind: "no chairs" also the
// armchairs, "no lamps" those on tables and floor. Whether there are any.
bool RefuseKind(const Handbook& handbook, const BriefText& text, std::size_t i, std::size_t length, BriefFacts& facts);

// "a bench if there is room", "perhaps a bench", "an optional bench". Words in `used` belong to something else.
bool IsOptional(const BriefText& text, const std::vector<bool>& used, std::size_t begin, std::size_t end);

// "only a bed and a wardrobe", "just a desk", "nothing but a sofa", "and nothing else".
bool AsksForNothingElse(const Handbook& handbook, const BriefText& text);

// "chair" of "dining chair".
std::string LastWord(const std::string& name);

// The class of the seats that come with a piece; null when none do.
const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook);

// The class of seats of which a room has one for each, at no table; null where it has none.
const hb::Furniture* SeatOfTheRoom(const hb::Archetype& room, const Handbook& handbook);

// Whether a class usually stands at, on or beside the other.
bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner);

// Whether a class stands on the floor and is not walked over.
bool IsFloorPiece(const hb::Furniture& furniture);

// How many can sit, or lie, on a piece of its usual size; 0 when it is for none.
int PlacesOn(const hb::Furniture& furniture);

// Whether one sits on it, at something: chairs and stools, not armchairs.
bool IsSeat(const hb::Furniture& furniture);

}  // namespace flair::language
