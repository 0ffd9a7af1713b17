// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "flair/v1/room.pb.h"

namespace flair::language {

// The wall that words mean: "north", "far", "left", "longest", "window", "across window". Far, near, left and right are
// as seen by whoever comes in by the first door; without a door as on the plan, with the near wall in the south. Of
// several walls that look one way the longest. Nothing when the room has no such wall or the words name none.
std::optional<int> WallOf(const v1::Room& room, std::string_view words);

// The corner of the floor (the index of its vertex) that words mean: "north east", "far left", "far". Never one where
// the room goes round a corner. Nothing when the words name none.
std::optional<int> CornerOf(const v1::Room& room, std::string_view words);

// Index of the wall of that name; nothing when there is none.
std::optional<int> WallNamed(const v1::Room& room, std::string_view name);

// Length of a wall, metres.
double WallLength(const v1::Room& room, int wall);

}  // namespace flair::language
