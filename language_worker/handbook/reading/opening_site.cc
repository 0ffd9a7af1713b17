// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/opening_site.h"

#include <algorithm>
#include <string_view>

#include "language_worker/handbook/reading/wall_sides.h"

namespace flair::language {
namespace {

constexpr std::string_view kSiteVerbs =
    "is are be being should must will can could stands stand sits sit goes go set located placed positioned situated "
    "put "
    "which that opens open just directly all both";

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
  if (words_.At(i) == "right") return IsAmong("opposite next by beside near across in", words_.At(i + 1));
  return IsAmong(kSiteVerbs, words_.At(i));
}

// "50 cm from the left corner", "1 m from the west wall".
bool OpeningSiteReader::TakeFromEnd(std::size_t& i, OpeningSite& site) const {
  std::size_t at = 0;
  const std::optional<double> length_m = words_.LengthAt(i, at);
  const std::optional<std::size_t> from =
      length_m ? words_.BehindOneOf(at, "from|off|away from|in from|to the|left of|right of") : std::nullopt;
  if (!from) return false;
  at = words_.BehindArticle(*from);
  std::string end;
  while (IsAmong(kSiteSides, words_.At(at)) || words_.At(at) == "-" || words_.At(at) == "hand") {
    if (end.empty() && words_.At(at) != "-") end = words_.At(at);
    ++at;
  }
  if (!IsAmong("corner end wall edge side", words_.At(at)) && end.empty()) return false;
  if (IsAmong("corner end wall edge side", words_.At(at))) ++at;
  site.along = {At::kEnd, end, length_m};
  if (words_.At(at) == "of") TakeSides(++at, /*bare=*/true, site);
  i = at;
  return true;
}

// "in the middle of the west wall", "centred on it", "midway along the north wall"; not of the room.
bool OpeningSiteReader::TakeMiddle(std::size_t& i, OpeningSite& site) const {
  std::size_t at = i;
  bool of = false;
  if (const auto centred =
          words_.BehindOneOf(at, "centred|centered|centrally placed|centrally|central|midway|halfway")) {
    at = *centred;
    of = IsAmong("in on along at down within", words_.At(at));
    if (of) ++at;
  } else {
    const auto middle = words_.BehindOneOf(at,
                                           "in the middle|in the centre|in the center|at the middle|at the centre|at "
                                           "the center|on the middle|on the centre");
    if (!middle) return false;
    at = *middle;
    of = words_.At(at) == "of";
    if (of) ++at;
  }
  if (of) {
    const std::size_t sides = at;
    const auto that = words_.BehindOneOf(at, "it|that wall|the wall|this wall|one wall|a wall|its wall|the same wall");
    if (!TakeSides(at, /*bare=*/true, site)) {
      if (!that) return false;
      at = *that;
    } else if (at == sides) {
      return false;
    }
  }
  site.along.at = At::kMiddle;
  i = at;
  return true;
}

// "at the west end of the north wall", "in the north-east corner", "near a corner", "on the left of the south wall".
bool OpeningSiteReader::TakeEnd(std::size_t& i, OpeningSite& site) const {
  std::size_t at = i;
  const auto close = words_.BehindOneOf(at, "close to|next to|right in|up against");
  if (!close && !IsAmong("at in near towards toward by on to tight beside", words_.At(at))) return false;
  at = words_.BehindArticle(close.value_or(at + 1));
  std::vector<std::string> ends;
  while (ends.size() < 2 &&
         (IsAmong(kSiteSides, words_.At(at)) || words_.At(at) == "northeast" || words_.At(at) == "northwest" ||
          words_.At(at) == "southeast" || words_.At(at) == "southwest")) {
    const std::string word(words_.At(at));
    if (word.size() == 9) {
      ends = {word.substr(0, 5), word.substr(5)};
    } else {
      ends.push_back(word);
    }
    ++at;
    if (words_.IsHyphen(at) && words_.At(at + 1) != "hand") ++at;
  }
  if (const auto hand = words_.Behind(at, "hand")) at = *hand;
  if (words_.IsHyphen(at) && words_.At(at + 1) == "hand") at += 2;
  const std::string_view noun = words_.At(at);
  const bool corner = IsAmong("corner corners", noun), end = IsAmong("end ends part half edge", noun);
  if (corner || end || IsAmong("side", noun)) ++at;
  const bool of = words_.At(at) == "of";
  std::size_t behind = at + 1;
  OpeningSite of_wall = site;
  bool wall = of && TakeSides(behind, /*bare=*/true, of_wall);
  if (of && !wall) {
    const auto that = words_.BehindOneOf(at + 1, "it|that wall|the wall|this wall|one wall|a wall|its wall");
    wall = that.has_value() && !site.sides.empty();
    if (wall) behind = *that;
  }
  if (wall && (corner || end || !ends.empty())) {
    site = of_wall;
    at = behind;
  } else if (corner && ends.size() == 2 && site.sides.empty()) {
    site.sides = {ends[0]};
    ends.erase(ends.begin());
  } else if (end && site.sides.empty() && ends.size() == 1) {
    // "a window at the north end" of a room.
    site.sides = {ends[0]};
    i = at;
    return true;
  } else if (!corner && !(end && !site.sides.empty())) {
    return false;
  }
  if (const auto room = words_.BehindOneOf(at, "of the room|of this room")) at = *room;
  std::size_t behind_length = 0;
  if (of && words_.LengthAt(words_.BehindArticle(at + 1), behind_length) && words_.At(behind_length) == "wall") {
    site.not_read = words_.Quote(i, behind_length + 1);
    at = behind_length + 1;
  }
  site.along.at = At::kEnd;
  // Of "the north-east corner of the north wall" the east one.
  for (const std::string& one : ends) {
    if (site.sides.empty() || one != site.sides[0]) site.along.end = one;
  }
  i = at;
  return true;
}

OpeningSite OpeningSiteReader::ReadBefore(std::size_t begin) const {
  constexpr std::size_t kMostWords = 10;
  OpeningSite best;
  for (std::size_t start = begin - std::min(begin, kMostWords); start < begin; ++start) {
    const bool opens = start == 0 ||
                       (words_.IsSign(start - 1) && !words_.IsHyphen(start - 1) && words_.At(start - 1) != "'") ||
                       IsAmong("and with where has have while but", words_.At(start - 1));
    if (!opens) continue;
    OpeningSite site;
    std::size_t at = start;
    const bool into = IsAmong(kIntoWords, words_.At(at));
    if (!(TakeMiddle(at, site) || TakeEnd(at, site) || TakeSides(at, /*bare=*/true, site))) continue;
    if (site.sides.empty()) continue;
    bool linked = at == begin && into;
    bool has = false;
    while (at < begin && (IsAmong("there is are has have with should be must a i want", words_.At(at)) ||
                          IsAmong(", : - s '", words_.At(at)))) {
      has = has || IsAmong("has have with :", words_.At(at));
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
