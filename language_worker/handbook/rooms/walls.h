// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/reading/opening_reader.h"

namespace flair::language {

// The wall that words mean: "north", "far", "left", "longest", "window", "across window". Far, near, left and right are
// as seen by whoever comes in by the first door; without a door as on the plan, with the near wall in the south. Of
// several walls that look one way the longest. Nothing when the room has no such wall or the words name none.
std::optional<int> WallOf(const v1::Room& room, std::string_view words);

// Whether words tell a wall or corner as seen from the door: "far left".
bool GoesByTheDoor(std::string_view words);

// The door, or window, that words before it mean: by where it leads ("kitchen") or by its wall ("north"), the widest
// there. Null when the words tell none.
const v1::Opening* OpeningOf(const v1::Room& room, v1::OpeningKind kind, std::string_view words);

// The corner of the floor (the index of its vertex) that words mean: "north east", "far left", "far", "at door", or
// "across" from another one. Never one where
// the room goes round a corner. Nothing when the words name none.
std::optional<int> CornerOf(const v1::Room& room, std::string_view words);

// Index of the wall of that name; nothing when there is none.
std::optional<int> WallNamed(const v1::Room& room, std::string_view name);

// Whether a wall has no opening.
bool IsBlank(const v1::Room& room, int wall);

// Length of a wall, metres.
double WallLength(const v1::Room& room, int wall);

// The point so far along a wall.
v1::Point2 PointOn(const v1::Room& room, int wall, double offset_m);

// 0 for a wall in the south, which runs east, 1 for one in the east, and so on.
int HeadingOf(const v1::Room& room, int wall);

// Whether the room goes round the corner at that vertex, instead of ending in it.
bool IsReentrant(const v1::Room& room, int corner);

// A part of a wall, from its start, metres.
struct WallSpan {
  double offset_m = 0;
  double width_m = 0;
};

// What an opening needs of its wall.
struct OpeningSize {
  double width_m = 0;
  double least_m = 0;   // narrower it is none
  double corner_m = 0;  // kept free at the wall's ends
};

// Finds room for openings in a wall beside those that it has. Ends of a wall: "left" and "right" are as on the plan for
// walls in the south and north, and as seen by whoever faces the wall for those in the east and west.
class WallSpace {
 public:
  // The room must outlive it; its openings are looked at anew each time.
  explicit WallSpace(const v1::Room& room) : room_(room) {}

  // A place for one opening, at most as wide as asked; nothing when there is none of the least width. Where `along` has
  // no room the widest free part is taken, and `moved` is set.
  std::optional<WallSpan> Place(int wall, const OpeningSize& size, const AlongWall& along, bool& moved) const;

  // Places for several, evenly over the free parts; fewer when there is no room for all.
  std::vector<WallSpan> Spread(int wall, int count, const OpeningSize& size) const;

  // Places side by side, each about `pane_m` wide, over all that is free.
  std::vector<WallSpan> Fill(int wall, double pane_m, const OpeningSize& size) const;

  // Whether those words mean the wall's end vertex; nothing when they do not tell its ends apart.
  std::optional<bool> IsEnd(int wall, const std::string& words) const;

 private:
  std::vector<WallSpan> Free(int wall, double corner_m) const;

  const v1::Room& room_;
};

}  // namespace flair::language
