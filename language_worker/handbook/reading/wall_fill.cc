// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/wall_fill.h"

#include <algorithm>
#include <cmath>

#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

// What is told of walls: how many of them, and which sides of the room they are.
struct Walls {
  int count = 0;
  bool is_long = false, is_short = false;
};

// "Along the long wall", "on three walls", "lining the walls"; pieces "on the wall" are not a row of them.
Walls WallsBehind(const BriefText& text, std::size_t end) {
  constexpr std::size_t kMostWords = 7;
  constexpr int kAll = 3;  // the fourth has the door
  Walls walls;
  bool along = false, all = false;
  int number = 0;
  for (std::size_t i = end; i < end + kMostWords && i < text.size() && !text.IsSign(i); ++i) {
    if (text.Says(i, {"and", "with", "for"})) break;
    along = along || text.Is(i, "along_walls");
    all = all || text.Says(i, {"all", "every", "each"});
    walls.is_long = walls.is_long || text.At(i) == "long";
    walls.is_short = walls.is_short || text.At(i) == "short";
    if (const auto said = NumberWord(text.At(i)); said && !text.Is(i, "articles")) number = *said;
    if (!IsFormIn("wall_nouns", text.At(i))) continue;
    const bool many = text.At(i).ends_with('s') || number > 1;
    if (!many) {
      walls.count = along ? 1 : 0;
    } else {
      walls.count = number > 0 ? std::min(number, kAll) : (all || along ? kAll : 0);
    }
    break;
  }
  return walls;
}

}  // namespace

int CountAlongWalls(const BriefText& text, const hb::Furniture& furniture, std::size_t end, const BriefFacts& facts) {
  constexpr double kShareOfWall = 0.65, kShareOfFloor = 0.14;
  constexpr int kMostAtAWall = 6;
  if (!IsFloorPiece(furniture) || furniture.back() != hb::BACK_RULE_WALL || PlacesOn(furniture) > 0) return 0;
  const Walls walls = WallsBehind(text, end);
  if (walls.count == 0) return 0;
  const hb::Archetype& room = *facts.archetype;
  const double width_m = facts.size.width_m.value_or(room.width_m().typical());
  const double depth_m = facts.size.depth_m.value_or(room.depth_m().typical());
  const double side_m = walls.is_long    ? std::max(width_m, depth_m)
                        : walls.is_short ? std::min(width_m, depth_m)
                                         : (width_m + depth_m) / 2;
  const double piece_m = furniture.width_m().typical(), piece_m2 = piece_m * furniture.depth_m().typical();
  const int at_each = std::clamp(static_cast<int>(kShareOfWall * side_m / piece_m), 2, kMostAtAWall);
  const int most = static_cast<int>(kShareOfFloor * width_m * depth_m / piece_m2);
  return std::max(2, std::min(walls.count * at_each, most));
}

}  // namespace flair::language
