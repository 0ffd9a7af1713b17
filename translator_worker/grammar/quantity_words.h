// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <string_view>

namespace flair::translator {

// The words that lengths are made of: data of JoinQuantities.
struct Unit {
  std::string_view word;
  double metres;
};
inline constexpr std::array kUnits = {
    Unit{"m", 1},
    Unit{"metre", 1},
    Unit{"metres", 1},
    Unit{"meter", 1},
    Unit{"meters", 1},
    Unit{"cm", 0.01},
    Unit{"centimetre", .01},
    Unit{"centimetres", .01},
    Unit{"centimeter", .01},
    Unit{"centimeters", .01},
    Unit{"mm", 0.001},
    Unit{"millimetres", .001},
    Unit{"millimeters", .001},
    Unit{"ft", 0.3048},
    Unit{"foot", 0.3048},
    Unit{"feet", 0.3048},
    Unit{"inch", 0.0254},
    Unit{"inches", 0.0254},
    Unit{"yard", 0.9144},
    Unit{"yards", 0.9144},
};

struct NumberWord {
  std::string_view word;
  double value;
};
inline constexpr std::array kNumberWords = {
    NumberWord{"zero", 0},     NumberWord{"half", 0.5},  NumberWord{"a", 1},        NumberWord{"an", 1},
    NumberWord{"one", 1},      NumberWord{"two", 2},     NumberWord{"three", 3},    NumberWord{"four", 4},
    NumberWord{"five", 5},     NumberWord{"six", 6},     NumberWord{"eight", 8},    NumberWord{"ten", 10},
    NumberWord{"seven", 7},    NumberWord{"nine", 9},    NumberWord{"fifteen", 15}, NumberWord{"twenty", 20},
    NumberWord{"thirty", 30},  NumberWord{"forty", 40},  NumberWord{"fifty", 50},   NumberWord{"sixty", 60},
    NumberWord{"seventy", 70}, NumberWord{"eighty", 80}, NumberWord{"ninety", 90},  NumberWord{"hundred", 100},
};

enum class Bound { kExact, kMin, kMax };

struct Qualifier {
  std::initializer_list<std::string_view> words;
  Bound bound;
};

// Longest first. Words that stand before a length.
inline const Qualifier kQualifiers[] = {
    {{"not", "be", "less", "than"}, Bound::kMin},
    {{"not", "be", "closer", "than"}, Bound::kMin},
    {{"not", "be", "more", "than"}, Bound::kMax},
    {{"not", "be", "further", "than"}, Bound::kMax},
    {{"not", "be", "farther", "than"}, Bound::kMax},
    {{"not", "exceed"}, Bound::kMax},
    {{"not", "exceeding"}, Bound::kMax},
    {{"no", "less", "than"}, Bound::kMin},
    {{"not", "less", "than"}, Bound::kMin},
    {{"no", "more", "than"}, Bound::kMax},
    {{"not", "more", "than"}, Bound::kMax},
    {{"no", "further", "than"}, Bound::kMax},
    {{"no", "farther", "than"}, Bound::kMax},
    {{"no", "greater", "than"}, Bound::kMax},
    {{"not", "further", "than"}, Bound::kMax},
    {{"no", "closer", "than"}, Bound::kMin},
    {{"no", "nearer", "than"}, Bound::kMin},
    {{"not", "nearer", "than"}, Bound::kMin},
    {{"nearer", "than"}, Bound::kMin},
    {{"not", "closer", "than"}, Bound::kMin},
    {{"less", "than"}, Bound::kMax},
    {{"closer", "than"}, Bound::kMin},
    {{"more", "than"}, Bound::kMin},
    {{"greater", "than"}, Bound::kMin},
    {{"at", "least"}, Bound::kMin},
    {{"a", "minimum", "of"}, Bound::kMin},
    {{"minimum", "of"}, Bound::kMin},
    {{"a", "maximum", "of"}, Bound::kMax},
    {{"maximum", "of"}, Bound::kMax},
    {{"at", "most"}, Bound::kMax},
    {{"up", "to"}, Bound::kMax},
    {{"within"}, Bound::kMax},
    {{"minimum"}, Bound::kMin},
    {{"maximum"}, Bound::kMax},
    {{"min"}, Bound::kMin},
    {{"max"}, Bound::kMax},
    {{"over"}, Bound::kMin},
};

// Words that stand after a length.
inline const Qualifier kQualifiersAfter[] = {
    {{"or", "more"}, Bound::kMin},         {{"or", "greater"}, Bound::kMin}, {{"or", "larger"}, Bound::kMin},
    {{"or", "longer"}, Bound::kMin},       {{"or", "further"}, Bound::kMin}, {{"or", "farther"}, Bound::kMin},
    {{"or", "above"}, Bound::kMin},        {{"or", "wider"}, Bound::kMin},   {{"and", "more"}, Bound::kMin},
    {{"at", "the", "least"}, Bound::kMin}, {{"at", "least"}, Bound::kMin},   {{"at", "minimum"}, Bound::kMin},
    {{"at", "a", "minimum"}, Bound::kMin}, {{"minimum"}, Bound::kMin},       {{"min"}, Bound::kMin},
    {{"or", "less"}, Bound::kMax},         {{"or", "closer"}, Bound::kMax},  {{"or", "nearer"}, Bound::kMax},
    {{"or", "below"}, Bound::kMax},        {{"at", "most"}, Bound::kMax},    {{"at", "the", "most"}, Bound::kMax},
    {{"at", "maximum"}, Bound::kMax},      {{"maximum"}, Bound::kMax},       {{"max"}, Bound::kMax},
};

// Words that may stand between a qualifier and its length: "a minimum clear distance of 0.5 m".
inline constexpr std::array<std::string_view, 25> kBetween = {
    "depth", "distance", "gap",           "space",   "spacing", "clearance", "separation", "of",      "clear",
    "a",     "an",       "about",         "around",  "free",    "width",     "walkway",    "roughly", "is",
    "be",    "should",   "approximately", "exactly", "buffer",  "another",   "the"};
inline constexpr std::array<std::string_view, 12> kDimensionWords = {
    "wide", "long", "deep", "high", "tall", "square", "thick", "width", "length", "height", "depth", "diameter"};

inline constexpr std::array<std::string_view, 16> kSpaceWords = {
    "open",     "opened", "pass", "walk",    "legroom", "clearance",    "space", "gap",
    "distance", "room",   "out",  "spacing", "clear",   "unobstructed", "free",  "accessible"};

inline constexpr std::array<std::string_view, 10> kGapWords = {
    "gap", "clearance", "separation", "buffer", "spacing", "space", "path", "pathway", "walkway", "passage"};

}  // namespace flair::translator
