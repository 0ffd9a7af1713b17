// SPDX-License-Identifier: GPL-3.0-or-later
// Walls, their ends and corners as briefs name them: "the long glass side", "both short walls", "the north-east
// corner".
#include <string>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

using Sides = std::vector<std::string>;

bool IsLength(std::string_view side) { return IsIn("long_or_short", side); }

// "both long walls", "two sides", "all four walls"; "the wall opposite" and "the same wall" go by others.
Sides SeveralWallsAt(const BriefText& words, std::size_t i, std::size_t& end) {
  const std::pair<const char*, Sides> kSeveral[] = {{"the_other_wall", {"opposite"}},
                                                    {"the_same_wall", {"same"}},
                                                    {"both_long_walls", {"long", "across long"}},
                                                    {"both_short_walls", {"short", "across short"}},
                                                    {"all_walls", {"far", "left", "right", "near"}},
                                                    {"three_walls", {"far", "left", "right"}},
                                                    {"one_end", {"short"}},
                                                    {"the_street", {"street"}},
                                                    {"one_long_wall", {"long"}},
                                                    {"one_short_wall", {"short"}},
                                                    {"facing_walls", {"left", "right"}},
                                                    {"two_walls", {"far", "left"}},
                                                    {"three_northern_faces", {"north", "north west", "north east"}},
                                                    {"three_southern_faces", {"south", "south west", "south east"}},
                                                    {"three_eastern_faces", {"east", "north east", "south east"}},
                                                    {"three_western_faces", {"west", "north west", "south west"}}};
  for (const auto& [list, sides] : kSeveral) {
    const auto behind = words.BehindPhrase(i, list);
    if (!behind) continue;
    end = *behind;
    return sides;
  }
  const auto rest = words.BehindPhrase(i, "the_other");
  if (!rest || !EndsWall(words, *rest)) return {};
  end = *rest;
  return {"opposite"};
}

}  // namespace

bool EndsWall(const BriefText& words, std::size_t i) {
  return words.IsSign(i) || i >= words.size() || words.Is(i, "after_a_wall");
}

WallTarget WallTargetAt(const BriefText& words, std::size_t at) {
  WallTarget target;
  at = words.BehindArticle(at);
  std::string street;
  for (int most = 4; most > 0; --most) {
    const std::string side(words.At(at));
    // "The long glass side", "the street side", "the gable end".
    std::size_t noun = at;
    while (words.Is(noun, "wall_looks")) ++noun;
    const bool look = noun > at && (words.Is(noun, "wall_nouns") || words.Is(noun, "wall_ends") ||
                                    (words.Is(noun, "wall_sides") && words.Is(noun + 1, "wall_nouns")));
    if (look) {
      if (words.Is(at, "end_walls") || (words.Is(at, "street_walls") && words.Is(noun, "wall_ends"))) street = "short";
      if (words.Is(at, "street_walls") && street.empty()) street = "near";
      at = noun;
    } else if (target.sides.size() < 2 && words.Is(at, "compass_corners")) {
      constexpr std::size_t kNorth = 5;  // letters of "north" and "south"
      target.sides = {side.substr(0, kNorth), side.substr(kNorth)};
      ++at;
    } else if (target.sides.size() < 2 && words.Is(at, "wall_sides")) {
      target.sides.push_back(side == "narrow" ? "short" : side);
      at += words.At(at + 1) == "hand" ? 2 : 1;
    } else {
      break;
    }
  }
  target.corner = words.Is(at, "corners");
  target.end_of_wall = words.Is(at, "wall_ends");
  const bool face = words.Is(at, "faces_of_walls") && !target.sides.empty() && IsIn("compass", target.sides[0]) &&
                    EndsWall(words, at + 1);
  target.wall = words.Is(at, "wall_nouns") || face;
  if (target.sides.empty() && !street.empty()) target.sides = {street};
  // "The street end" is a wall.
  target.wall = target.wall || (target.end_of_wall && !street.empty());
  target.several = words.At(at).ends_with('s');
  if (target.corner || target.end_of_wall || target.wall) ++at;
  target.end = words.BehindPhrase(at, "of_the_room").value_or(at);
  return target;
}

std::vector<std::string> WallsAt(const BriefText& words, std::size_t at, bool alone, std::size_t& end) {
  constexpr std::size_t kMostSides = 4;
  if (Sides several = SeveralWallsAt(words, at, end); !several.empty()) return several;
  Sides sides;
  bool any_noun = false;
  while (sides.size() < kMostSides) {
    std::size_t next = at;
    while (!sides.empty() && next < at + 2 && words.Is(next, "and_signs")) ++next;
    if (!sides.empty() && next == at) break;
    if (!sides.empty() && words.Is(next, "into")) ++next;
    if (const auto share = words.BehindPhrase(next, "whole_length"); share && !sides.empty()) next = *share;
    const WallTarget target = WallTargetAt(words, next);
    const bool noun = target.wall || (target.end_of_wall && target.sides.size() == 1);
    if (target.sides.empty() || target.sides.size() > 2 || target.corner) break;
    // "The short north wall": the compass tells.
    std::string side = IsLength(target.sides[0]) ? target.sides.back() : target.sides[0];
    const bool slanting =
        target.sides.size() == 2 && target.wall && IsIn("compass", target.sides[0]) && IsIn("compass", target.sides[1]);
    if (target.sides.size() == 2 && !IsLength(target.sides[0]) && !slanting) break;
    if (slanting) side = target.sides[0] + " " + target.sides[1];
    const bool compass = slanting || IsIn("compass", side), closes = EndsWall(words, target.end);
    // "On the west wall, at the far end": of that wall.
    if (!sides.empty() && target.end_of_wall && !target.wall && words.At(at) == "," && words.At(at + 1) != "and") break;
    // "and the north wall is blue", "left sofa", "to the left of the bed": another thing.
    if (!sides.empty() && !(noun && closes) && !(closes && !any_noun && compass)) break;
    if (!noun && (words.At(target.end) == "of" || IsIn("sides_with_a_noun", side))) break;
    if (!noun && !closes && (alone || !compass)) break;
    sides.push_back(side);
    if (noun && target.several && IsLength(side) && sides.size() == 1) sides.push_back("across " + side);
    any_noun = any_noun || noun;
    at = end = target.end;
  }
  return sides;
}

}  // namespace flair::language
