// SPDX-License-Identifier: GPL-3.0-or-later
// A user's own room, and what it may leave out (docs/rooms.md).
#pragma once

#include <filesystem>

#include "absl/status/statusor.h"
#include "flair/v1/room.pb.h"

namespace flair::cli {

// A room: an artifact that holds one (also a layout's or graph's), or a Room message itself, completed, in any of their
// forms. Errors as ReadArtifact.
absl::StatusOr<v1::Room> ReadRoom(const std::filesystem::path& path);

// Fills in what a hand-written room leaves out and brings it into the form that the protocol asks for:
//   - height_m 0: 3 m;
//   - no walls: the sides of an upright rectangle are named south, east, north and west, those of any other floor
//     wall_1, wall_2, ... in the order in which the corners were given;
//   - a door without leaf opens inward, hinged at its start, by 90 degrees; an opening without id or head height gets
//     one;
//   - corners listed clockwise are turned round, with walls, offsets and hinges, so that everything stays in its place;
//   - the floor is moved so that its bounding box begins at (0, 0).
// Leaves everything else, faults included, as it is.
void CompleteRoom(v1::Room& room);

}  // namespace flair::cli
