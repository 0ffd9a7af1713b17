// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/room.h"

#include <gtest/gtest.h>

#include "room/geometry/pose.h"
#include "room/scene/scene.h"

namespace flair {
namespace {

TEST(Room, ARectanglesWallsAreNamedByTheCompass) {
  const Room room = RectangularRoom(4, 3);
  EXPECT_EQ(room.walls[0].name, "south");
  EXPECT_EQ(room.walls[1].name, "east");
  EXPECT_EQ(room.walls[2].name, "north");
  EXPECT_EQ(room.walls[3].name, "west");
  EXPECT_EQ(room.walls[1].length_m, 3);
}

TEST(Room, ObjectsWithTheirBackOnAWallHaveItsBackHeading) {
  const Room room = RectangularRoom(4, 3);
  EXPECT_NEAR(room.walls[0].BackHeading(), 0, 1e-15);
  EXPECT_NEAR(room.walls[1].BackHeading(), kPi / 2, 1e-15);
  EXPECT_NEAR(room.walls[2].BackHeading(), kPi, 1e-15);
  EXPECT_NEAR(room.walls[3].BackHeading(), 3 * kPi / 2, 1e-15);
}

TEST(Room, OffsetAndHeightAreMeasuredFromTheWallsStart) {
  const Room room = RectangularRoom(4, 3);
  EXPECT_EQ(room.walls[2].Offset(Vec2<double>{3, 2}), 1);
  EXPECT_EQ(room.walls[2].Height(Vec2<double>{3, 2}), 1);
  EXPECT_EQ(room.walls[2].PointAt(1), (Vec2<double>{3, 3}));
}

TEST(Room, OtherShapesHaveNumberedWalls) {
  EXPECT_EQ(WallsOf({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}})[3].name, "wall_4");
}

TEST(Room, NumberedWallsAreCalledByTheirSide) {
  Room room;
  room.walls = WallsOf({{{0, 0}, {4, 0}, {4, 2}, {2.5, 2}, {2.5, 4}, {0, 4}}});
  EXPECT_EQ(WallName(room, room.walls[0]), "the south wall");
  EXPECT_EQ(WallName(room, room.walls[2]), "the 1.50 m north wall");
  EXPECT_EQ(WallName(room, room.walls[4]), "the 2.50 m north wall");
  room.walls[4].name = "garden";
  EXPECT_EQ(WallName(room, room.walls[4]), "the garden wall");
  EXPECT_EQ(WallName(room, room.walls[2]), "the north wall");
}

TEST(Scene, AThingOnATableIsAsHighAsTheTable) {
  Scene scene;
  scene.objects.resize(2);
  scene.objects[0].height_m = 0.7;
  scene.objects[1].kind = ObjectKind::kSurface;
  scene.objects[1].host = 0;
  scene.objects[1].height_m = 0.3;
  EXPECT_DOUBLE_EQ(scene.BottomOf(1), 0.7);
  EXPECT_DOUBLE_EQ(scene.TopOf(1), 1.0);
}

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
      const Polygon swing = ConvexSwingAreas(room, room.openings[0]).at(0);
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
    EXPECT_TRUE(ConvexSwingAreas(room, room.openings[0]).empty());
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
