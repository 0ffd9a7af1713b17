// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes that a stranger gives, held against the room and against what is usual.
#pragma once

#include <string>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/objects/fit_floor.h"
#include "llm/answers/length_unit.h"

namespace flair::language {

// Extents of one object, metres.
struct ObjectSize {
  double width_m = 0;
  double depth_m = 0;
  double height_m = 0;
};

// Whether its footprint fits between the room's walls in one of its turns.
bool FitsFloor(const ObjectSize& size, const FloorExtent& floor);

// What is odd about a size of that class, as a fault's text: more than 2.5 times as large as the class gets or as much
// smaller, as lengths in a wrong unit are; empty when nothing is, or the class is not known.
std::string OddSize(const ObjectSize& size, const hb::Furniture* furniture);

// How its lengths go with what is usual for that class and with the floor, as far as the class is known.
llm::LengthEvidence EvidenceOf(const ObjectSize& size, const hb::Furniture* furniture, const FloorExtent& floor);

// "2.2 m x 0.6 m"
std::string FootprintText(const ObjectSize& size);

}  // namespace flair::language
