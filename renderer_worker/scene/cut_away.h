// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "renderer_worker/scene/room_shape.h"

namespace flair::renderer {

enum class WallCut {
  kWhole,
  kStub,  // cut at kStubHeight_m
  kGone,
};

// What a camera does not see, so that it sees the room.
struct CutAway {
  bool ceiling = false;        // and what hangs from it
  std::vector<WallCut> walls;  // as RoomShape::walls; with them goes what hangs on them
  // Of a wall's index, -1 for no wall.
  bool Takes(int wall) const { return wall >= 0 && walls[wall] != WallCut::kWhole; }
};

// From above the ceiling: no ceiling, stubs of the walls that would hide floor. From outside a wall, below the ceiling:
// the walls seen from behind are gone. From within the room: nothing is cut.
CutAway CutAwayFor(const RoomShape& shape, Vec3 eye);

}  // namespace flair::renderer
