// SPDX-License-Identifier: GPL-3.0-or-later
// Where along its wall an opening is: at an end, in the middle, so far from a corner.
#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

using At = AlongWall::At;

}  // namespace

// "50 cm from the left corner", "1 m from the west wall".
bool OpeningSiteReader::TakeFromEnd(std::size_t& i, OpeningSite& site) const {
  std::size_t at = 0;
  const std::optional<double> length_m = words_.LengthAt(i, at);
  const std::optional<std::size_t> from = length_m ? words_.BehindPhrase(at, "measured_from") : std::nullopt;
  if (!from) return false;
  at = words_.BehindArticle(*from);
  std::string end;
  while (words_.Is(at, "wall_sides") || words_.At(at) == "-" || words_.At(at) == "hand") {
    if (end.empty() && words_.At(at) != "-") end = words_.At(at);
    ++at;
  }
  if (!words_.Is(at, "wall_parts") && end.empty()) return false;
  if (words_.Is(at, "wall_parts")) ++at;
  site.along = {At::kEnd, end, length_m};
  if (words_.At(at) == "of") TakeSides(++at, /*bare=*/true, site);
  i = at;
  return true;
}

// "in the middle of the west wall", "centred on it", "midway along the north wall"; not of the room.
bool OpeningSiteReader::TakeMiddle(std::size_t& i, OpeningSite& site) const {
  std::size_t at = i;
  bool of = false;
  if (const auto centred = words_.BehindPhrase(at, "centred")) {
    at = *centred;
    of = words_.Is(at, "centred_on");
    if (of) ++at;
  } else {
    const auto middle = words_.BehindPhrase(at, "in_the_middle");
    if (!middle) return false;
    at = *middle;
    of = words_.At(at) == "of";
    if (of) ++at;
  }
  if (of) {
    const std::size_t sides = at;
    const auto that = words_.BehindPhrase(at, "that_wall");
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
  const auto close = words_.BehindPhrase(at, "close_to");
  if (!close && !words_.Is(at, "at_or_near")) return false;
  at = words_.BehindArticle(close.value_or(at + 1));
  std::vector<std::string> ends;
  while (ends.size() < 2 &&
         (words_.Is(at, "wall_sides") || words_.At(at) == "northeast" || words_.At(at) == "northwest" ||
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
  const bool corner = IsOneOf(noun, {"corner", "corners"}), end = IsIn("wall_ends", noun);
  if (corner || end || IsOneOf(noun, {"side"})) ++at;
  const bool of = words_.At(at) == "of";
  std::size_t behind = at + 1;
  OpeningSite of_wall = site;
  bool wall = of && TakeSides(behind, /*bare=*/true, of_wall);
  if (of && !wall) {
    const auto that = words_.BehindPhrase(at + 1, "that_wall");
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
  if (const auto room = words_.BehindPhrase(at, "of_the_room")) at = *room;
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

}  // namespace flair::language
