// SPDX-License-Identifier: GPL-3.0-or-later
// The places of openings that go by other openings, by the way in, and by furniture.
#include <string_view>

#include "language_worker/handbook/reading/opening_site.h"
#include "language_worker/handbook/reading/wall_sides.h"

namespace flair::language {
namespace {

constexpr std::string_view kOpeningWords = "door doors doorway entrance window windows";

}  // namespace

// "opposite the door", "either side of the door", "next to the window", "opposite each other".
bool OpeningSiteReader::TakeFeature(std::size_t& i, bool door, OpeningSite& site) const {
  std::size_t at = i;
  const auto across = words_.BehindOneOf(
      at,
      "opposite to|opposite|across from|facing|in line with|straight across from|on the wall opposite|on the wall "
      "facing|"
      "on the opposite wall to|on the opposite wall from|on the opposite side from|on the opposite side to|faces|face");
  const auto beside = words_.BehindOneOf(at,
                                         "next to|left and right of|to the left and right of|beside|alongside|adjacent "
                                         "to|close to|near|by|left of|right of|to "
                                         "the left of|to the right of|on the left of|"
                                         "on the right of|either side of|on either side of|on both sides of|on the "
                                         "same wall as|in the same wall as|flanking");
  if (!across && !beside) return false;
  // The wall that was said holds.
  OpeningSite kept;
  if (!site.sides.empty()) kept = site;
  at = words_.BehindArticle(across ? *across : *beside);
  if (across && words_.Behind(at, "each other")) {
    site.sides = {"left", "right"};
    i = at + 2;
    return true;
  }
  // "two windows opposite", "a door beside it": of what was named last.
  const bool closes = at >= words_.size() || words_.IsSign(at) || IsAmong("and with", words_.At(at));
  if ((across && closes) || words_.At(at) == "it") {
    site.sides = {across ? "opposite" : "beside"};
    i = words_.At(at) == "it" ? at + 1 : at;
    return true;
  }
  if (words_.At(at) == "other") ++at;
  if (IsAmong("main front room entry entrance bedroom", words_.At(at)) && IsAmong(kOpeningWords, words_.At(at + 1)))
    ++at;
  if (!IsAmong(kOpeningWords, words_.At(at))) return false;
  const bool window = words_.At(at).starts_with("window");
  site.pair =
      beside &&
      (words_
           .BehindOneOf(
               i,
               "either side of|on either side of|on both sides of|flanking|left and right of|to the left and right of")
           .has_value());
  i = at + 1;
  OpeningSite of_it;
  if (window == door && TakeSides(i, /*bare=*/false, of_it) && of_it.sides.size() == 1) {
    site.by_side = of_it.sides[0];
    site.sides = {across ? "across " + site.by_side : site.by_side};
  } else if (window != door) {
    // A window by a window, a door by a door.
    site.sides = {across ? "across same" : "same"};
  } else {
    site.sides = {window ? (across ? "across window" : "window") : (across ? "far" : "near")};
  }
  if (!kept.sides.empty()) {
    site.sides = kept.sides;
    site.by_side.clear();
  }
  return true;
}

// "on the left as you enter", "straight ahead when you come in"; alone "as you enter" tells nothing but is passed over.
bool OpeningSiteReader::TakeEntering(std::size_t& i, OpeningSite& site) const {
  constexpr std::string_view kEntering =
      "as you enter|when you enter|as you come in|when you come in|as you walk in|when you walk in|on entering|upon "
      "entering|"
      "entering|from the door|as one enters|when entering|coming in|as we enter|from the entrance|in front of you";
  std::size_t at = i;
  const auto first = words_.BehindOneOf(at, kEntering);
  if (first) at = *first;
  if (first && words_.At(at) == ",") ++at;
  if (first && words_.BehindOneOf(at, "the room|the space")) at += 2;
  const auto ahead =
      words_.BehindOneOf(at, "straight ahead|dead ahead|ahead|straight across|in front of you|on the far side");
  const auto left = words_.BehindOneOf(
      at, "on your left|on the left hand side|on the left hand|to the left|to your left|on the left");
  const auto right = words_.BehindOneOf(
      at, "on your right|on the right hand side|on the right hand|to the right|to your right|on the right");
  const auto behind = words_.BehindOneOf(at, "behind you");
  const auto way = ahead ? ahead : left ? left : right ? right : behind;
  if (!way) {
    if (first && !site.sides.empty()) i = at;
    return first && !site.sides.empty();
  }
  if (words_.At(*way) == "of" || IsAmong(kWallNouns, words_.At(*way)) || IsAmong("hand end corner", words_.At(*way)) ||
      words_.IsHyphen(*way)) {
    return false;
  }
  if (!site.sides.empty()) {
    if (ahead || behind) return false;
    site.along = {AlongWall::At::kEnd, left ? "left" : "right", {}};
  } else {
    site.sides = {ahead ? "far" : left ? "left" : right ? "right" : "near"};
  }
  at = *way;
  if (const auto then = words_.BehindOneOf(words_.At(at) == "," ? at + 1 : at, kEntering)) at = *then;
  i = at;
  return true;
}

// "above the sink", "behind the sofa": a place that goes by a piece of furniture.
bool OpeningSiteReader::TakeThing(std::size_t& i, OpeningSite& site) const {
  constexpr std::size_t kMostWords = 4;
  const auto by =
      words_.BehindOneOf(i,
                         "above|over|behind|opposite|either side of|on either side of|on both sides of|between|"
                         "across from|next to|beside|near");
  if (!by) return false;
  std::size_t at = *by;
  while (at < *by + kMostWords && at < words_.size() && !words_.IsSign(at) &&
         !IsAmong("and with or but where that which for is are on in at", words_.At(at))) {
    ++at;
  }
  if (at == *by) return false;
  site.not_read = words_.Quote(i, at);
  i = at;
  return true;
}

}  // namespace flair::language
