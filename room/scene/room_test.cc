// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/scene/room.h"

#include <gtest/gtest.h>

#include "room/geometry/angle.h"
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

}  // namespace
}  // namespace flair
