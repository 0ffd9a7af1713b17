// SPDX-License-Identifier: GPL-3.0-or-later
// The walls among the places of openings.
#include <algorithm>
#include <string_view>

#include "language_worker/handbook/reading/opening_site.h"
#include "language_worker/handbook/reading/wall_sides.h"

namespace flair::language {
namespace {

// "along the whole length of the east wall" is along it.
constexpr std::string_view kWhole =
    "whole length of|whole of|entire length of|full length of|length of|full width of|width of|whole|entire";

void AddSide(const std::string& side, OpeningSite& site) {
  if (std::find(site.sides.begin(), site.sides.end(), side) == site.sides.end()) site.sides.push_back(side);
}

}  // namespace

// "both long walls", "two sides", "all four walls".
bool OpeningSiteReader::TakeSeveralSides(std::size_t& i, OpeningSite& site) const {
  std::size_t at = i;
  if (const auto facing =
          words_.BehindOneOf(at, "the wall opposite|the wall facing it|the other wall|the facing wall")) {
    site.sides = {"opposite"};
    i = *facing;
    return true;
  }
  if (const auto same = words_.BehindOneOf(at, "the same wall|one wall|a single wall|the same side")) {
    site.sides = {"same"};
    i = *same;
    return true;
  }
  const std::string_view how = words_.At(at);
  if (!IsAmong("both each either opposite two three all every four adjacent adjoining neighbouring", how)) return false;
  ++at;
  while (IsAmong("the of opposite adjacent adjoining two three four other", words_.At(at))) ++at;
  std::string_view which;
  if (IsAmong("long longer longest short shorter shortest", words_.At(at))) which = words_.At(at++);
  const bool end = IsAmong("end ends", words_.At(at));
  if (!end && !IsAmong("wall walls side sides", words_.At(at))) return false;
  const std::string said = words_.Quote(i, at);
  const auto says = [&](std::string_view word) { return IsAmong(said, word); };
  if (!which.empty() || end) {
    const std::string side = which.starts_with("long") ? "long" : "short";
    site.sides = {side, "across " + side};
  } else if (says("all") || says("four") || how == "every" || (how == "each" && words_.At(at) == "wall")) {
    site.sides = {"far", "left", "right", "near"};
  } else if (says("three")) {
    site.sides = {"far", "left", "right"};
  } else if (says("opposite") || how == "both" || how == "either" || how == "each") {
    site.sides = {"left", "right"};
  } else {
    site.sides = {"far", "left"};
  }
  i = at + 1;
  return true;
}

// One wall's words at a token, behind an article: "the left-hand", "north", "longer"; `noun` says whether "wall"
// followed.
std::string OpeningSiteReader::SideAt(std::size_t i, std::size_t& end, bool& noun) const {
  std::size_t at = words_.BehindArticle(i);
  if (!IsAmong(kSiteSides, words_.At(at))) return "";
  std::string side(words_.At(at++));
  if (words_.IsHyphen(at) && words_.At(at + 1) == "hand") {
    at += 2;
  } else if (words_.At(at) == "hand") {
    ++at;
  }
  if (side == "narrow") side = "short";
  noun = IsAmong(kWallNouns, words_.At(at)) || (words_.At(at) == "end" && IsAmong("far back rear front", side));
  if (noun) ++at;
  if (const auto room = words_.BehindOneOf(at, "of the room|of this room|of the house|of the building")) at = *room;
  end = at;
  return side;
}

// "on the north wall", "facing south", "to the left", "on the north and east walls"; `bare`: without "on".
bool OpeningSiteReader::TakeSides(std::size_t& i, bool bare, OpeningSite& site) const {
  constexpr int kMostSides = 4;
  std::size_t at = i;
  const bool into = IsAmong(kIntoWords, words_.At(at));
  if (into) ++at;
  if (const auto whole = words_.BehindOneOf(words_.BehindArticle(at), kWhole); whole && into) at = *whole;
  const bool several = TakeSeveralSides(at, site);
  if (several) {
    i = at;
    return into || bare;
  }
  // "in the 4 m wall"
  std::size_t behind_length = 0;
  if (into && words_.LengthAt(words_.BehindArticle(at), behind_length) &&
      IsAmong("wall side", words_.At(behind_length))) {
    site.not_read = words_.Quote(i, behind_length + 1);
    i = behind_length + 1;
    return true;
  }
  // "A window north and a door south" has no "on" either.
  const bool terse = IsAmong(kCompassPoints, words_.At(at));
  if (!into && !bare && !terse) return false;
  std::vector<std::string> sides;
  std::size_t end = at;
  bool any_noun = false;
  for (int n = 0; n < kMostSides; ++n) {
    std::size_t next = at, behind = 0;
    if (n > 0) {
      while (next < at + 2 && IsAmong(", and & / +", words_.At(next))) ++next;
      if (next == at) break;
      if (IsAmong(kIntoWords, words_.At(next))) ++next;
    }
    bool noun = false;
    const std::string side = SideAt(next, behind, noun);
    if (side.empty()) break;
    const std::string_view follows = words_.At(behind);
    const bool closes =
        words_.IsSign(behind) || behind >= words_.size() || IsAmong("and with or but as so where", follows);
    // "and the north wall is blue", "left sofa", "to the left of the bed": another thing.
    if (n > 0 && !(noun && closes) && !(closes && !any_noun && IsAmong(kCompassPoints, side))) break;
    if (!noun && follows == "of") break;
    if (!noun && n == 0 && !closes && !into) break;
    if (!noun && !closes && !IsAmong(kCompassPoints, side)) break;
    if (!noun && IsAmong("near opposite entrance long short", side)) break;
    sides.push_back(side);
    any_noun = any_noun || noun;
    at = end = behind;
  }
  if (sides.empty()) return false;
  for (const std::string& side : sides) AddSide(side, site);
  i = end;
  return true;
}

}  // namespace flair::language
