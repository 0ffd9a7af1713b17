// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "language_worker/handbook/choosing/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"

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

}  // namespace flair::language
