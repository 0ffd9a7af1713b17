// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/door_area.h"

#include <gtest/gtest.h>

#include "room/geometry/angle.h"

namespace flair {
namespace {

Room RoomWithDoor(int wall, HingeSide hinge, double angle_rad = kPi / 2) {
  Room room = RectangularRoom(4, 3);
  Opening door;
  door.wall = wall;
  door.offset_m = 1;
  door.width_m = 0.9;
  door.leaf.emplace();
  door.leaf->hinge = hinge;
  door.leaf->swing_angle_rad = angle_rad;
  room.openings.push_back(door);
  return room;
}

TEST(DoorArea, CoversTheQuarterDiscAndLittleMore) {
  for (HingeSide hinge : {HingeSide::kStart, HingeSide::kEnd}) {
    for (int wall = 0; wall < 4; ++wall) {
      const Room room = RoomWithDoor(wall, hinge);
      const Polygon swing = SwingArea(room, room.openings[0]);
      const double disc = kPi * 0.9 * 0.9 / 4;
      EXPECT_GT(SignedArea(swing.vertices), disc);
      EXPECT_LT(Area(swing), 1.01 * disc);
      EXPECT_TRUE(IsConvex(swing));
      const Vec2<double> h = HingePoint(room, room.openings[0]);
      const Wall& w = room.walls[static_cast<size_t>(wall)];
      EXPECT_TRUE(Contains(swing, h + 0.89 * w.inward_normal));
      EXPECT_TRUE(Contains(room.floor, h + 0.89 * w.inward_normal));
    }
  }
}

TEST(DoorArea, AHalfTurnIsTwoConvexPieces) {
  const Room room = RoomWithDoor(0, HingeSide::kStart, kPi);
  const auto pieces = ConvexSwingAreas(room, room.openings[0]);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_TRUE(IsConvex(pieces[0]));
  EXPECT_TRUE(IsConvex(pieces[1]));
}

TEST(DoorArea, OnlyLeavesThatOpenInwardsSweepTheRoom) {
  Room room = RoomWithDoor(0, HingeSide::kStart);
  for (DoorSwing swing : {DoorSwing::kOutward, DoorSwing::kSliding, DoorSwing::kNone}) {
    room.openings[0].leaf->swing = swing;
    EXPECT_TRUE(SwingArea(room, room.openings[0]).vertices.empty());
  }
}

TEST(DoorArea, PassageLiesBeforeTheOpening) {
  const Room room = RoomWithDoor(0, HingeSide::kStart);
  const Polygon passage = PassageArea(room, room.openings[0], 0.6, 0.1);
  EXPECT_NEAR(Area(passage), 1.1 * 0.6, 1e-12);
  EXPECT_TRUE(Contains(passage, {1.45, 0.3}));
}

}  // namespace
}  // namespace flair
