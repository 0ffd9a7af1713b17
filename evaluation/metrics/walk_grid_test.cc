// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluation/metrics/walk_grid.h"

#include <gtest/gtest.h>

#include "room/geometry/pose.h"

namespace flair::evaluation {
namespace {

// 4 m x 3 m with a door of 0.8 m in the south-west.
Room RoomWithDoor() {
  Room room = RectangularRoom(4, 3);
  Opening door;
  door.wall = 0;
  door.offset_m = 0.1;
  door.width_m = 0.8;
  door.leaf = DoorLeaf{HingeSide::kStart, DoorSwing::kInward, kPi / 2};
  room.openings.push_back(door);
  return room;
}

TEST(WalkGrid, AnEmptyRoomIsReachedButForItsCorners) {
  WalkGrid grid(RoomWithDoor(), 0.6);
  const WalkResult result = grid.Measure({});
  EXPECT_TRUE(result.door_free);
  EXPECT_GT(result.reachable_share, 0.98);
}

TEST(WalkGrid, AWallOfFurnitureCutsTheRoom) {
  WalkGrid grid(RoomWithDoor(), 0.6);
  const Obstacle wall[] = {{{2, 1.5, 0}, {0.4, 3}}};
  const WalkResult result = grid.Measure(wall);
  EXPECT_NEAR(result.reachable_share, 0.5, 0.03);
}

TEST(WalkGrid, AWayOfThePathsWidthIsOpenAndANarrowerOneIsNot) {
  WalkGrid grid(RoomWithDoor(), 0.6);
  const Obstacle wide[] = {{{2, 1.2, 0}, {0.4, 2.4}}};
  EXPECT_GT(grid.Measure(wide).reachable_share, 0.95);
  const Obstacle narrow[] = {{{2, 1.25, 0}, {0.4, 2.5}}};
  EXPECT_LT(grid.Measure(narrow).reachable_share, 0.6);
}

TEST(WalkGrid, FineCellsTellAGapAFewCentimetresTooNarrow) {
  WalkGrid coarse(RoomWithDoor(), 0.6), fine(RoomWithDoor(), 0.6, kFineCell_m);
  const Obstacle gap_of_56_cm[] = {{{2, 1.22, 0}, {0.4, 2.44}}};
  EXPECT_GT(coarse.Measure(gap_of_56_cm).reachable_share, 0.95);
  EXPECT_LT(fine.Measure(gap_of_56_cm).reachable_share, 0.6);
  const Obstacle gap_of_60_cm[] = {{{2, 1.2, 0}, {0.4, 2.4}}};
  EXPECT_GT(fine.Measure(gap_of_60_cm).reachable_share, 0.95);
}

TEST(WalkGrid, CountsFrontsThatCannotBeStoodAt) {
  WalkGrid grid(RoomWithDoor(), 0.6);
  const Obstacle facing_the_room[] = {{{3, 2.75, kPi}, {1, 0.5}}};
  EXPECT_EQ(grid.Measure(facing_the_room).blocked_fronts, 0);
  const Obstacle facing_the_wall[] = {{{3, 2.75, 0}, {1, 0.5}}};
  EXPECT_EQ(grid.Measure(facing_the_wall).blocked_fronts, 1);
}

TEST(WalkGrid, ABlockedDoorMakesEverythingUnreachable) {
  WalkGrid grid(RoomWithDoor(), 0.6);
  const Obstacle plug[] = {{{0.5, 0.5, 0}, {1, 1}}};
  const WalkResult result = grid.Measure(plug);
  EXPECT_FALSE(result.door_free);
  EXPECT_EQ(result.reachable_share, 0);
}

TEST(WalkGrid, WithoutADoorTheLargestAreaCounts) {
  WalkGrid grid(RectangularRoom(4, 3), 0.6);
  const Obstacle wall[] = {{{1.2, 1.5, 0}, {0.4, 3}}};
  EXPECT_NEAR(grid.Measure(wall).reachable_share, 2.6 / 3.6, 0.03);
}

}  // namespace
}  // namespace flair::evaluation
