// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Outlines that the handbook can draw.
enum class RoomShape { kRectangle, kL, kT, kU };

// What a brief says about the room's outline.
struct ShapeRequest {
  RoomShape shape = RoomShape::kRectangle;
  // The word for an outline that cannot be drawn, as written but in lower case: "hexagonal"; else empty.
  std::string unknown;
};

// Reads "L-shaped", "T shape", "shaped like a U" and words such as "round" where they speak of the room; an L-shaped
// sofa and a round table do not. The first such word counts.
ShapeRequest ReadShape(const std::vector<Token>& tokens, const Handbook& handbook);

}  // namespace flair::language
