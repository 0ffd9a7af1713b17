// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the word for an opening and tells of itself: its look, where it leads, its lengths and its swing.
#include <algorithm>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/opening_parts.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

namespace {

constexpr double kLarge = 1.5, kSmall = 0.6;

}  // namespace

void Describe(std::string_view word, OpeningWish& wish) {
  if (IsIn("large", word)) {
    wish.width_factor = kLarge;
  } else if (IsIn("small", word)) {
    wish.width_factor = kSmall;
  }
  if (!wish.door) {
    if (IsIn("compass", word) && wish.side.empty()) wish.side = word;
    if (IsOneOf(word, {"clerestory"})) wish.sill_m = 1.9;
    if (word == "bay" || word == "bow" || word == "oriel") {
      wish.kind = std::string(word) + " window";
      wish.width_factor = kLarge;
    }
    if (word == "corner") wish.along.at = AlongWall::At::kEnd;
    return;
  }
  if (IsIn("sliding", word)) wish.swing = v1::DOOR_SWING_SLIDING;
  if (IsIn("folding", word)) {
    wish.swing = v1::DOOR_SWING_SLIDING;
    wish.width_m = wish.width_m.value_or(2.4);
  }
  if (word == "double") wish.width_m = wish.width_m.value_or(1.5);
  if (word == "garage") wish.width_m = wish.width_m.value_or(2.4);
  if (IsIn("open_air", word) || word == "french") {
    wish.outside = true;
    if (word != "balcony") wish.width_m = wish.width_m.value_or(word == "patio" ? 1.8 : 1.5);
    if (word == "patio") wish.swing = v1::DOOR_SWING_SLIDING;
    if (word != "french") wish.leads_to = word;
  } else if (IsIn("inner_rooms", word)) {
    wish.leads_to = std::string(word) + (wish.leads_to.empty() ? "" : " " + wish.leads_to);
  }
}

namespace {

// "to the kitchen", "leading out to the garden", "onto the balcony".
bool TakeLeads(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (words.Says(at, {"that", "which"})) ++at;
  if (words.Is(at, "leading")) ++at;
  if (words.Says(at, {"out", "on", "through"}) && words.Says(at + 1, {"to", "onto", "into"})) ++at;
  if (!words.Is(at, "leads_to")) return false;
  at = words.BehindArticle(at + 1);
  if (words.Is(at, "before_other_rooms")) {
    if (!words.Is(at + 1, "open_air") && !words.Is(at + 1, "inner_rooms") && !words.Is(at + 1, "ways_in") &&
        words.At(at + 1) != "room") {
      return false;
    }
    ++at;
  }
  const std::string_view word = words.At(at);
  const bool open_air = IsIn("open_air", word), inner = IsIn("inner_rooms", word) || word == "room";
  if (!open_air && !inner && !IsIn("ways_in", word)) return false;
  // "a door to the side wall" is none that leads to a side.
  if (IsIn("sides_of_a_house", word)) return false;
  std::size_t end = at + 1;
  if (words.IsHyphen(end)) ++end;
  if (words.Is(end, "room_endings")) ++end;
  if (open_air) {
    wish.outside = true;
    if (word != "balcony") wish.width_m = wish.width_m.value_or(wish.count == 1 ? 0.9 : 1.5);
  }
  if (open_air || inner) wish.leads_to = words.Quote(at, end);
  i = end;
  return true;
}

// "1.2 m wide", "of 1.2 m x 1.5 m", "(90 cm)", "with a sill at 1.1 m".
bool TakeLengths(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (words.At(at) == ",") ++at;
  const bool bracket = words.At(at) == "(";
  if (bracket) ++at;
  bool sill = false;
  for (int over = 0; over < 6 && words.Is(at, "before_opening_sizes"); ++over) {
    sill = sill || words.At(at) == "sill";
    if (sill && words.Says(at, {"low", "high"})) return false;
    ++at;
  }
  std::size_t end = 0;
  const std::optional<double> first = words.LengthAt(at, end);
  if (!first || *first <= 0) return false;
  if (words.Says(end, {"from", "off"}) || words.At(end) == "away" || words.Says(end, {"to", "left", "right"}))
    return false;
  if (sill || words.BehindPhrase(end, "above_the_floor")) {
    wish.sill_m = *first;
    i = sill ? end : end + 3;
    return true;
  }
  if (words.Says(end, {"high", "tall"})) {
    wish.height_m = *first;
  } else {
    wish.width_m = *first;
  }
  at = words.Is(end, "opening_dimensions") ? end + 1 : end;
  if (words.Says(at, {"x", "by", "and"})) {
    const std::optional<double> second = words.LengthAt(at + 1, end);
    if (second && *second > 0) {
      wish.height_m = *second;
      at = words.Says(end, {"high", "tall"}) ? end + 1 : end;
    }
  }
  if (bracket && words.At(at) == ")") ++at;
  i = at;
  return true;
}

// "opening outwards", "that swings into the room", "reaching the floor".
bool TakeSwing(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  for (int over = 0; over < 3 && words.Is(at, "before_swings"); ++over) ++at;
  if (wish.door) {
    if (!words.Is(at, "swinging")) return false;
    const auto out = words.BehindPhrase(at + 1, "outwards");
    const auto in = words.BehindPhrase(at + 1, "inwards");
    if (!out && !in) return false;
    if (words.Says(out.value_or(*in), {"to", "onto", "the"})) return false;
    wish.swing = out ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
    i = out.value_or(in.value_or(at));
    return true;
  }
  const auto full = words.BehindPhrase(at, "floor_to_ceiling");
  if (!full) return false;
  wish.sill_m = 0;
  wish.to_ceiling = words.Quote(at, *full).find("ceiling") != std::string::npos;
  i = *full;
  return true;
}

}  // namespace

std::size_t ReadMeasures(const BriefText& words, std::size_t i, OpeningWish& wish) {
  constexpr int kMostParts = 4;
  for (int part = 0; part < kMostParts; ++part) {
    if (!(wish.door && TakeLeads(words, i, wish)) && !TakeLengths(words, i, wish) && !TakeSwing(words, i, wish)) break;
  }
  return i;
}

}  // namespace flair::language
