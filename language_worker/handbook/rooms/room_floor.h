// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a room within its bounding rectangle of the size that a brief names:
//   L  the rectangle without a corner of 2/5 x 2/5 of its sides: 84 % of it; the corner by seed
//   T  a bar of half the depth, and a stem of half the width in the middle: 75 %; the side that the stem points to by
//   seed U  the rectangle without the middle third of one side, half as deep: 83 %; the side by seed
// An area in the brief is the area of the floor, not of the rectangle. Arms are never narrower than 1.5 m: a smaller
// room stays a rectangle, with a diagnostic.
#pragma once

#include <cmath>
#include <string>

#include "flair/v1/room.pb.h"
#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/shape_phrase.h"

namespace flair::language {

// Extent of a rectangular room, metres, and how it was found.
struct RoomSize {
  double width_m = 0;
  double depth_m = 0;
  double height_m = 3;
  std::string assumption;  // one sentence when the brief left something open, else empty
};

// To 5 cm: lengths of walls are no finer.
inline double RoundToStep(double length_m) { return std::round(length_m * 20) / 20; }

// The size that the brief gives, completed by the archetype's usual one, or a larger one where that is too small for
// what the brief asks for.
RoomSize ChooseRoomSize(const BriefFacts& facts, const Handbook& handbook, const Choice& choice);

// Sets the floor and the walls, "south", "east", "north", "west" of a rectangle and "wall_1", "wall_2" ... of others,
// and adds the diagnostics "shape_unknown" and "shape_too_small" (warnings) where the shape could not be had.
void SetFloor(const ShapeRequest& request, const SizeRequest& asked, const RoomSize& size, const Choice& choice,
              v1::Room& room);

}  // namespace flair::language
