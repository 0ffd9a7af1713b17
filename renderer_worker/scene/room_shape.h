// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/room.pb.h"
#include "renderer_worker/scene/mesh_builder.h"

namespace flair::renderer {

// A hole in a wall, in the wall's axes: u along the wall from its start, w above the floor.
struct ShapedOpening {
  const v1::Opening* opening = nullptr;
  float u0 = 0, u1 = 0;
  float w0 = 0, w1 = 0;
  bool door() const { return opening->kind() == v1::OPENING_KIND_DOOR; }
};

// One wall: its inner face runs along the floor's edge, its body outwards. The outer face is mitred with the
// neighbours': it runs from outer_start to outer_end, in the wall's axes.
struct ShapedWall {
  std::string name;
  Axes axes;  // along the edge counter-clockwise, outward, up; left-handed
  float length_m = 0;
  float outer_start = 0;
  float outer_end = 0;
  std::vector<ShapedOpening> openings;  // those with an area, cut to the wall
};

// The room as solids: what shell, cameras and cut-aways are made of.
struct RoomShape {
  std::vector<Vec2> floor;
  float height_m = 3;
  float wall_thickness_m = 0.15F;
  std::vector<ShapedWall> walls;
};

inline constexpr float kSlabThickness_m = 0.12F;

// INVALID_ARGUMENT with the field's path for what is no room.
absl::StatusOr<RoomShape> ShapeOf(const v1::Room& room);

// Strictly inside the floor.
bool Inside(const RoomShape& shape, float x, float y);
// How far along `direction` (unit) an eye is from the room's inside, walls or not, between floor and ceiling; 0 for an
// eye within, infinite where it looks past.
float WayIn(const RoomShape& shape, Vec3 eye, Vec3 direction);

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
