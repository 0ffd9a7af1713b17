// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

struct Reading;

// What a brief says of a surface of the room: "walls covered in cork", "an oak floor", "dark green walls".
struct AskedFinish {
  enum class Surface { kWalls, kFloor, kCeiling };
  Surface surface = Surface::kWalls;
  std::string material = {};                // as said; empty where only the colour is
  const hb::NamedColour* colour = nullptr;  // null where only the material is said
  std::size_t begin = 0, end = 0;           // the tokens that say it
};

// Reads them and marks the tokens that it has used. Words in `used` belong to something else. One finish a surface: the
// first.
void ReadFinishes(const Reading& reading);

}  // namespace flair::language
