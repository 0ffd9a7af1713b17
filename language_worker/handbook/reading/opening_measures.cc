// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind the words for an opening and tells of itself.
#include <string_view>

#include "language_worker/handbook/reading/opening_noun.h"
#include "language_worker/handbook/reading/opening_places.h"

namespace flair::language {
namespace {

// "to the kitchen", "leading out to the garden", "onto the balcony".
bool TakeLeads(const OpeningWords& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (IsAmong("that which", words.At(at))) ++at;
  if (IsAmong("leading leads opening opens going goes giving gives", words.At(at))) ++at;
  if (IsAmong("out on through", words.At(at)) && IsAmong("to onto into", words.At(at + 1))) ++at;
  if (!IsAmong("to onto into for on between", words.At(at))) return false;
  at = words.BehindArticle(at + 1);
  if (IsAmong("small little adjoining adjacent next back front rear", words.At(at))) {
    if (!IsAmong(kOpenAir, words.At(at + 1)) && !IsAmong(kInnerRooms, words.At(at + 1)) &&
        !IsAmong(kWaysIn, words.At(at + 1)) && words.At(at + 1) != "room") {
      return false;
    }
    ++at;
  }
  const std::string_view word = words.At(at);
  const bool open_air = IsAmong(kOpenAir, word), inner = IsAmong(kInnerRooms, word) || word == "room";
  if (!open_air && !inner && !IsAmong(kWaysIn, word)) return false;
  // "a door to the side wall" is none that leads to a side.
  if (IsAmong("side back front main service", word)) return false;
  std::size_t end = at + 1;
  if (words.IsHyphen(end)) ++end;
  if (IsAmong("room suite garden area closet", words.At(end))) ++end;
  if (open_air) {
    wish.outside = true;
    if (word != "balcony") wish.width_m = wish.width_m.value_or(wish.count == 1 ? 0.9 : 1.5);
  }
  if (open_air || inner) wish.leads_to = words.Quote(at, end);
  i = end;
  return true;
}

// "1.2 m wide", "of 1.2 m x 1.5 m", "(90 cm)", "with a sill at 1.1 m".
bool TakeLengths(const OpeningWords& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (words.At(at) == ",") ++at;
  const bool bracket = words.At(at) == "(";
  if (bracket) ++at;
  bool sill = false;
  for (int over = 0; over < 6 && IsAmong("is are of with that which measuring about a at sill height low high starting",
                                         words.At(at));
       ++over) {
    sill = sill || words.At(at) == "sill";
    if (sill && IsAmong("low high", words.At(at))) return false;
    ++at;
  }
  std::size_t end = 0;
  const std::optional<double> first = words.LengthAt(at, end);
  if (!first || *first <= 0) return false;
  if (IsAmong("from off", words.At(end)) || words.At(end) == "away" || IsAmong("to left right", words.At(end)))
    return false;
  if (sill || words.BehindOneOf(end, "above the floor|off the floor|from the floor")) {
    wish.sill_m = *first;
    i = sill ? end : end + 3;
    return true;
  }
  if (IsAmong("high tall", words.At(end))) {
    wish.height_m = *first;
  } else {
    wish.width_m = *first;
  }
  at = IsAmong("wide high tall each long", words.At(end)) ? end + 1 : end;
  if (IsAmong("x by and", words.At(at))) {
    const std::optional<double> second = words.LengthAt(at + 1, end);
    if (second && *second > 0) {
      wish.height_m = *second;
      at = IsAmong("high tall", words.At(end)) ? end + 1 : end;
    }
  }
  if (bracket && words.At(at) == ")") ++at;
  i = at;
  return true;
}

// "opening outwards", "that swings into the room", "reaching the floor".
bool TakeSwing(const OpeningWords& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  for (int over = 0; over < 3 && IsAmong("that which and should to", words.At(at)); ++over) ++at;
  if (wish.door) {
    if (!IsAmong("opening opens open swinging swings swing", words.At(at))) return false;
    const auto out = words.BehindOneOf(at + 1, "outwards|outward|out|to the outside");
    const auto in = words.BehindOneOf(at + 1, "inwards|inward|into the room|in");
    if (!out && !in) return false;
    if (IsAmong("to onto the", words.At(out.value_or(*in)))) return false;
    wish.swing = out ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
    i = out.value_or(in.value_or(at));
    return true;
  }
  const auto full =
      words.BehindOneOf(at, "from floor to ceiling|floor to ceiling|down to the floor|reaching the floor|to the floor");
  if (!full) return false;
  wish.sill_m = 0;
  wish.to_ceiling = words.Quote(at, *full).find("ceiling") != std::string::npos;
  i = *full;
  return true;
}

}  // namespace

std::size_t ReadMeasures(const OpeningWords& words, std::size_t i, OpeningWish& wish) {
  constexpr int kMostParts = 4;
  for (int part = 0; part < kMostParts; ++part) {
    if (!(wish.door && TakeLeads(words, i, wish)) && !TakeLengths(words, i, wish) && !TakeSwing(words, i, wish)) break;
  }
  return i;
}

}  // namespace flair::language
