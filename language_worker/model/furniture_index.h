// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/objects/fit_floor.h"

namespace flair::language {

// Finds the handbook's class for a name that a stranger gave: "Oak writing desks" is a "writing desk", else a "desk".
// Immutable, thread-safe; `handbook` must outlive it.
class FurnitureIndex {
 public:
  explicit FurnitureIndex(const Handbook& handbook);

  // The class whose name or synonym is the longest ending of the name's words; null when none is.
  const hb::Furniture* Find(std::string_view name) const;

  // The class of exactly this name or synonym, plurals included; null when there is none.
  const hb::Furniture* FindExact(std::string_view name) const;

 private:
  std::map<std::string, const hb::Furniture*, std::less<>> by_word_;
};

// Whether a name is that of something to walk over: "rug", "bath mat", "carpet runner".
bool IsRugName(std::string_view name);

// The words of a name in lower case, one space between them, without other signs.
std::string PlainName(std::string_view name);

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

// "2.2 m x 0.6 m"
std::string FootprintText(const ObjectSize& size);

}  // namespace flair::language
