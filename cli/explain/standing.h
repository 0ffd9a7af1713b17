// SPDX-License-Identifier: GPL-3.0-or-later
// Where an object is, seen with the eyes of somebody in the room.
#pragma once

#include <string>

#include "room/conversion/conversion.h"
#include "room/scene/scene.h"

namespace flair::cli {

// "stands with its back to the north wall, under a window; nightstand 1 at its left". Begins with the verb, no full
// stop. For an object that is placed; neighbours that are not placed do not count. Walls, things and distances are
// read off the layout, whatever was asked.
std::string Standing(const Scene& scene, const PartialLayout& where, int object);

// "the north wall"; of a room that is no rectangle "wall_3 in the north".
std::string WallInWords(const Wall& wall);

// "north", "south-east": the compass direction nearest to a direction in the room.
std::string Compass(const Vec2<double>& direction);

}  // namespace flair::cli
