// SPDX-License-Identifier: GPL-3.0-or-later
// Which wall an opening is in: by its name, by other openings, by the way in, and by furniture.
#include <algorithm>
#include <string_view>

#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

void AddSide(const std::string& side, OpeningSite& site) {
  if (std::find(site.sides.begin(), site.sides.end(), side) == site.sides.end()) site.sides.push_back(side);
}

}  // namespace

// "both long walls", "two sides", "all four walls".
bool OpeningSiteReader::TakeSeveralSides(std::size_t& i, OpeningSite& site) const {
  std::size_t at = i;
  if (const auto facing = words_.BehindPhrase(at, "the_other_wall")) {
    site.sides = {"opposite"};
    i = *facing;
    return true;
  }
  if (const auto same = words_.BehindPhrase(at, "the_same_wall")) {
    site.sides = {"same"};
    i = *same;
    return true;
  }
  const std::string_view how = words_.At(at);
  if (!IsIn("several_walls", how)) return false;
  ++at;
  while (words_.Is(at, "numbers_of_walls")) ++at;
  std::string_view which;
  if (words_.Is(at, "long_or_short")) which = words_.At(at++);
  const bool end = words_.Says(at, {"end", "ends"});
  if (!end && !words_.Is(at, "wall_or_side")) return false;
  const auto says = [&](std::string_view word) {
    for (std::size_t k = i; k < at; ++k) {
      if (words_.At(k) == word) return true;
    }
    return false;
  };
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
  if (!words_.Is(at, "wall_sides")) return "";
  std::string side(words_.At(at++));
  if (words_.IsHyphen(at) && words_.At(at + 1) == "hand") {
    at += 2;
  } else if (words_.At(at) == "hand") {
    ++at;
  }
  if (side == "narrow") side = "short";
  noun = words_.Is(at, "wall_nouns") || (words_.At(at) == "end" && IsIn("far_or_near", side));
  if (noun) ++at;
  if (const auto room = words_.BehindPhrase(at, "of_the_room")) at = *room;
  end = at;
  return side;
}

// "on the north wall", "facing south", "to the left", "on the north and east walls"; `bare`: without "on".
bool OpeningSiteReader::TakeSides(std::size_t& i, bool bare, OpeningSite& site) const {
  constexpr int kMostSides = 4;
  std::size_t at = i;
  const bool into = words_.Is(at, "into");
  if (into) ++at;
  if (const auto whole = words_.BehindPhrase(words_.BehindArticle(at), "whole_length"); whole && into) at = *whole;
  const bool several = TakeSeveralSides(at, site);
  if (several) {
    i = at;
    return into || bare;
  }
  // "in the 4 m wall"
  std::size_t behind_length = 0;
  if (into && words_.LengthAt(words_.BehindArticle(at), behind_length) &&
      words_.Says(behind_length, {"wall", "side"})) {
    site.not_read = words_.Quote(i, behind_length + 1);
    i = behind_length + 1;
    return true;
  }
  // "A window north and a door south" has no "on" either.
  const bool terse = words_.Is(at, "compass");
  if (!into && !bare && !terse) return false;
  std::vector<std::string> sides;
  std::size_t end = at;
  bool any_noun = false;
  for (int n = 0; n < kMostSides; ++n) {
    std::size_t next = at, behind = 0;
    if (n > 0) {
      while (next < at + 2 && words_.Is(next, "and_signs")) ++next;
      if (next == at) break;
      if (words_.Is(next, "into")) ++next;
    }
    bool noun = false;
    const std::string side = SideAt(next, behind, noun);
    if (side.empty()) break;
    const std::string_view follows = words_.At(behind);
    const bool closes = words_.IsSign(behind) || behind >= words_.size() || IsIn("after_a_wall", follows);
    // "and the north wall is blue", "left sofa", "to the left of the bed": another thing.
    if (n > 0 && !(noun && closes) && !(closes && !any_noun && IsIn("compass", side))) break;
    if (!noun && follows == "of") break;
    if (!noun && n == 0 && !closes && !into) break;
    if (!noun && !closes && !IsIn("compass", side)) break;
    if (!noun && IsIn("sides_with_a_noun", side)) break;
    sides.push_back(side);
    any_noun = any_noun || noun;
    at = end = behind;
  }
  if (sides.empty()) return false;
  for (const std::string& side : sides) AddSide(side, site);
  i = end;
  return true;
}

// "opposite the door", "either side of the door", "next to the window", "opposite each other".
bool OpeningSiteReader::TakeFeature(std::size_t& i, bool door, OpeningSite& site) const {
  std::size_t at = i;
  const auto across = words_.BehindPhrase(at, "opposite_openings");
  const auto beside = words_.BehindPhrase(at, "beside_openings");
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
  const bool closes = at >= words_.size() || words_.IsSign(at) || words_.Says(at, {"and", "with"});
  if ((across && closes) || words_.At(at) == "it") {
    site.sides = {across ? "opposite" : "beside"};
    i = words_.At(at) == "it" ? at + 1 : at;
    return true;
  }
  if (words_.At(at) == "other") ++at;
  if (words_.Is(at, "which_door") && words_.Is(at + 1, "openings")) ++at;
  if (!words_.Is(at, "openings")) return false;
  const bool window = words_.At(at).starts_with("window");
  site.pair = beside && words_.BehindPhrase(i, "on_both_sides").has_value();
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
  std::size_t at = i;
  const auto first = words_.BehindPhrase(at, "entering");
  if (first) at = *first;
  if (first && words_.At(at) == ",") ++at;
  if (first && (words_.Behind(at, "the room") || words_.Behind(at, "the space"))) at += 2;
  const auto ahead = words_.BehindPhrase(at, "ahead");
  const auto left = words_.BehindPhrase(at, "on_the_left");
  const auto right = words_.BehindPhrase(at, "on_the_right");
  const auto behind = words_.Behind(at, "behind you");
  const auto way = ahead ? ahead : left ? left : right ? right : behind;
  if (!way) {
    if (first && !site.sides.empty()) i = at;
    return first && !site.sides.empty();
  }
  if (words_.At(*way) == "of" || words_.Is(*way, "wall_nouns") || words_.Says(*way, {"hand", "end", "corner"}) ||
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
  if (const auto then = words_.BehindPhrase(words_.At(at) == "," ? at + 1 : at, "entering")) at = *then;
  i = at;
  return true;
}

// "above the sink", "behind the sofa": a place that goes by a piece of furniture.
bool OpeningSiteReader::TakeThing(std::size_t& i, OpeningSite& site) const {
  constexpr std::size_t kMostWords = 4;
  const auto by = words_.BehindPhrase(i, "by_a_thing");
  if (!by) return false;
  std::size_t at = *by;
  while (at < *by + kMostWords && at < words_.size() && !words_.IsSign(at) && !words_.Is(at, "thing_stops")) {
    ++at;
  }
  if (at == *by) return false;
  site.not_read = words_.Quote(i, at);
  i = at;
  return true;
}

namespace {

using At = AlongWall::At;

}  // namespace

bool OpeningSiteReader::ReadAfter(std::size_t i, bool door, bool verbs, OpeningSite& site) const {
  constexpr int kMostParts = 6;
  bool any = false;
  for (int part = 0; part < kMostParts; ++part) {
    std::size_t at = i;
    // "door on the south wall, near the corner", "door: south wall", "window (north)".
    const bool pause = words_.At(at) == ",";
    const bool list =
        !any && (words_.At(at) == ":" || words_.At(at) == "(" || (words_.At(at) == "-" && !words_.IsHyphen(at)));
    if (pause || list) ++at;
    for (int over = 0; over < 4 && verbs && !pause && SaysNoPlace(at); ++over) ++at;
    const bool entering = TakeEntering(at, site);
    const bool taken = entering || TakeFromEnd(at, site) || TakeMiddle(at, site) ||
                       (!pause && TakeFeature(at, door, site)) || TakeEnd(at, site) ||
                       (!pause && TakeSides(at, list, site)) || (!any && !pause && TakeThing(at, site));
    if (!taken) break;
    if (list && words_.At(at) == ")") ++at;
    any = true;
    i = site.end = at;
  }
  return any;
}

// "is", "to be", the "right" of "right opposite": before the words for a place.
bool OpeningSiteReader::SaysNoPlace(std::size_t i) const {
  if (words_.At(i) == "to") return words_.At(i + 1) == "be";
  if (words_.At(i) == "right") return words_.Is(i + 1, "right_before_places");
  return words_.Is(i, "site_verbs");
}

OpeningSite OpeningSiteReader::ReadBefore(std::size_t begin) const {
  constexpr std::size_t kMostWords = 10;
  OpeningSite best;
  for (std::size_t start = begin - std::min(begin, kMostWords); start < begin; ++start) {
    const bool opens = start == 0 ||
                       (words_.IsSign(start - 1) && !words_.IsHyphen(start - 1) && words_.At(start - 1) != "'") ||
                       words_.Is(start - 1, "clause_starts");
    if (!opens) continue;
    OpeningSite site;
    std::size_t at = start;
    const bool into = words_.Is(at, "into");
    if (!(TakeMiddle(at, site) || TakeEnd(at, site) || TakeSides(at, /*bare=*/true, site))) continue;
    if (site.sides.empty()) continue;
    bool linked = at == begin && into;
    bool has = false;
    while (at < begin && (words_.Is(at, "there_is") || words_.Says(at, {",", ":", "-", "s", "'"}))) {
      has = has || words_.Says(at, {"has", "have", "with", ":"});
      ++at;
      linked = at == begin && (into || has);
    }
    if (!linked) continue;
    site.end = start;
    return site;
  }
  return best;
}

}  // namespace flair::language
