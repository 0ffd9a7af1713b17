// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, counts, lengths, areas and angles as people write them. Lengths come out in metres, areas in square metres,
// angles in degrees.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "english/text.h"

namespace flair::english {

// What a word counts: "two" 2, "a" 1, "both" 2, "dozen" 12, "several" 5; nothing for other words.
std::optional<double> NumberOf(std::string_view word);

struct Number {
  double value = 0;
  size_t end = 0;  // first token after it
};

// A number that begins at tokens[i]: "12", "1 1/2", "twelve", "twenty-five", "a hundred", "a dozen", "half a dozen",
// "one and a half", "three point two", "a few".
std::optional<Number> NumberAt(const std::vector<Token>& tokens, size_t i);

struct Measure {
  double value = 0;  // in metres, degrees or square metres when there is a unit
  double unit = 0;   // the unit's size; 0 when none is written
  size_t end = 0;
};

// A number with the unit of that kind behind it, if there is one: "0.6m", "half a metre", "2-foot", "5'6\"",
// "1 m 20 cm", 9'-0", "3 m 20", "ten foot six". Of KIND_AREA: "20 m2", "20 square metres", "215 sq ft", "6 tatami".
std::optional<Measure> MeasureAt(const std::vector<Token>& tokens, size_t i,
                                 v1::Unit::Kind kind = v1::Unit::KIND_LENGTH);

// Of tokens with clause marks only (KeepClauseMarks): joins numbers, units and the words that bound them to tokens of
// kind kLength. "0.6m", "60 cm", "half a metre", "2 ft", "0.3-1m", "at least 0.5 m", "no more than 30 cm", "0.5 m or
// more", "a minimum distance of 0.5 m" (the noun stays), "between 0.3 m and 0.5 m". Sizes of things are dropped, since
// they place nothing: "1.8m x 2.8m", "0.6m wide", "(1.5m)"; "the 1.8m side" becomes the one word "length:1.800", "the
// 1.8m sides" "lengths:1.800".
std::vector<Token> JoinLengths(std::vector<Token> tokens);

}  // namespace flair::english
