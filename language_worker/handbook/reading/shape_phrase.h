// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Outlines that the handbook can draw.
enum class RoomShape { kRectangle, kL, kT, kU, kRound, kOval, kOctagon, kHexagon, kNarrowing };

// What a brief says about the room's outline.
struct ShapeRequest {
  RoomShape shape = RoomShape::kRectangle;
  // The word for an outline that cannot be drawn, as written but in lower case: "triangular"; else empty.
  std::string unknown;
  std::size_t begin = 0, end = 0;       // the tokens that say it
  std::string narrow_end = {};          // of kNarrowing: "north", "far"; empty for any
  std::vector<std::string> parts = {};  // "half wall", "mezzanine": cannot be drawn
};

// How the units of a kitchen stand along the walls.
enum class RunForm { kAny, kStraight, kRoundCorner, kRoundTwoCorners, kFacing };

// Reads "units in an L", "a U-shaped kitchen", "galley": of a room with such units. What it takes of `shape` is the
// units', not the outline.
// The tokens that say it are added to `told`.
RunForm ReadRunForm(const std::vector<Token>& tokens, ShapeRequest& shape, std::vector<std::size_t>& told);

// Reads "L-shaped", "T shape", "shaped like a U" and words such as "round" where they speak of the room; an L-shaped
// sofa and a round table do not. The first such word counts, then that the room is a turret or a yurt.
ShapeRequest ReadShape(const std::vector<Token>& tokens, const Handbook& handbook);

}  // namespace flair::language
