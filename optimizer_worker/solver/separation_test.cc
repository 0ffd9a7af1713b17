// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/separation.h"

#include <gtest/gtest.h>

#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

Object Piece(double width_m, double depth_m) {
  Object object;
  object.footprint = {width_m, depth_m};
  object.height_m = 1;
  return object;
}

Scene SceneOf(Room room, std::vector<Object> objects) { return {std::move(room), {}, std::move(objects)}; }

Room LShapedRoom() {
  Room room;
  room.floor.vertices = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  room.walls = WallsOf(room.floor);
  return room;
}

TEST(Separate, MeasuresDistanceAndPenetrationOfRectangles) {
  const auto box = [](const Footprint& footprint, double x, double y) {
    return flair::Box<double>(footprint, FrameOf(Pose<double>{x, y, 0}));
  };
  EXPECT_NEAR(Separate(box({2, 1}, 0, 0), box({1, 1}, 2, 0)).gap_m, 0.5, 1e-12);
  EXPECT_NEAR(Separate(box({2, 1}, 0, 0), box({1, 1}, 1.4, 0.1)).gap_m, -0.1, 1e-12);
}

TEST(FindViolations, NamesOverlapsAndObjectsOutside) {
  const Scene scene = SceneOf(RectangularRoom(4, 3), {Piece(1, 1), Piece(1, 1)});
  const KeepOut keep_out(scene.room);
  const int objects[] = {0, 1};
  const Layout good = {{0.5, 0.5, 0}, {1.5, 0.5, kPi / 2}};
  EXPECT_TRUE(FindViolations(scene, keep_out, objects, good, 1e-9).empty());
  const Layout bad = {{0.4, 0.5, 0}, {1.2, 0.5, 0}};
  const std::vector<Violation> found = FindViolations(scene, keep_out, objects, bad, 1e-9);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].other, -1);
  EXPECT_NEAR(found[0].depth_m, 0.1, 1e-12);
  EXPECT_EQ(found[1].other, 0);
  EXPECT_NEAR(found[1].depth_m, 0.2, 1e-12);
}

TEST(KeepOut, TheNotchOfAnLShapedRoomIsOutside) {
  const Scene scene = SceneOf(LShapedRoom(), {Piece(1, 1)});
  const KeepOut keep_out(scene.room);
  const int objects[] = {0};
  EXPECT_TRUE(FindViolations(scene, keep_out, objects, {{1.5, 2.5, 0}}, 1e-9).empty());
  EXPECT_TRUE(FindViolations(scene, keep_out, objects, {{3.5, 1.5, 0}}, 1e-9).empty());
  EXPECT_FALSE(FindViolations(scene, keep_out, objects, {{2.5, 2.5, 0}}, 1e-9).empty());
  EXPECT_FALSE(FindViolations(scene, keep_out, objects, {{1.6, 2.4, 0}}, 1e-9).empty());
}

TEST(KeepOut, SwingAndPassageOfADoorStayFree) {
  Room room = RectangularRoom(4, 3);
  Opening door;
  door.wall = 0;
  door.offset_m = 1;
  door.width_m = 0.8;
  door.leaf = DoorLeaf{HingeSide::kStart, DoorSwing::kInward, kPi / 2};
  room.openings.push_back(door);
  const Scene scene = SceneOf(room, {Piece(0.5, 0.5)});
  const KeepOut keep_out(scene.room);
  const int objects[] = {0};
  const std::vector<Violation> found = FindViolations(scene, keep_out, objects, {{1.4, 0.3, 0}}, 1e-9);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found[0].at_door);
  EXPECT_TRUE(FindViolations(scene, keep_out, objects, {{2.1, 0.3, 0}}, 1e-9).empty());
}

TEST(SeparationRows, ProjectionEndsWithoutOverlap) {
  const Scene scene = SceneOf(RectangularRoom(4, 3), {Piece(1, 1), Piece(1.5, 1), Piece(0.5, 2)});
  const KeepOut keep_out(scene.room);
  const std::vector<int> free = {0, 1, 2};
  Layout layout = {{0.3, 0.6, 0}, {1.2, 0.7, 0.3}, {1.5, 1.0, 0}};
  for (int round = 0; round < 3; ++round) {
    const auto rows = SeparationRows(scene, keep_out, free, {}, layout, 1.0, 1e-7);
    std::vector<double> x;
    for (int i : free) x.insert(x.end(), {layout[i].x_m, layout[i].y_m});
    ProjectOntoRows(rows, x, 500);
    for (int i : free) layout[i] = {x[2 * i], x[2 * i + 1], layout[i].theta_rad};
  }
  EXPECT_TRUE(FindViolations(scene, keep_out, free, layout, 1e-8).empty());
}

}  // namespace
}  // namespace flair::optimizer
