// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "room/geometry/gap.h"

namespace flair::optimizer {
namespace {

constexpr double kWay_m = 0.6;
constexpr Vec2<double> kCorner = {3, 2};

// An L whose corner at (3, 2) juts into the room, with one bench.
Scene RoomWithABench(double width_m, double depth_m) {
  Scene scene;
  scene.room.floor.vertices = {{0, 0}, {6, 0}, {6, 5}, {3, 5}, kCorner, {0, 2}};
  scene.room.walls = WallsOf(scene.room.floor);
  Object bench;
  bench.id = bench.name = "bench";
  bench.footprint = {width_m, depth_m};
  scene.objects.push_back(bench);
  return scene;
}

std::vector<Pose<double>> Slides(const Scene& scene, const Pose<double>& pose) {
  std::vector<Pose<double>> slides;
  ProposeSlidesOffCorners(scene.room, scene.objects[0].footprint, pose, kWay_m, slides);
  return slides;
}

double ToCorner(const Scene& scene, const Pose<double>& pose) {
  return Gap<double>(Box<double>{scene.objects[0].footprint, FrameOf(pose)}, ConvexPiece(Segment{kCorner, kCorner}));
}

// Slides that leave exactly a way to the corner.
int CountOfWays(const Scene& scene, const std::vector<Pose<double>>& slides) {
  return static_cast<int>(std::count_if(slides.begin(), slides.end(), [&](const Pose<double>& slide) {
    return std::abs(ToCorner(scene, slide) - kWay_m) < 1e-6;
  }));
}

TEST(SlidesOffCorners, LeaveAWayToACornerThatJutsIntoTheRoom) {
  const Scene scene = RoomWithABench(1.2, 0.4);
  // The bench's own corner is 0.42 m to the right of the room's and 0.41 m below it.
  const Pose<double> pose = {kCorner.x + 0.42 + 0.6, kCorner.y - 0.41 - 0.2, 0};
  ASSERT_NEAR(ToCorner(scene, pose), std::hypot(0.42, 0.41), 1e-9);
  const std::vector<Pose<double>> slides = Slides(scene, pose);
  // To the right, down, and straight away.
  EXPECT_EQ(CountOfWays(scene, slides), 3);
  for (const Pose<double>& slide : slides) EXPECT_EQ(slide.theta_rad, pose.theta_rad);
}

TEST(SlidesOffCorners, LeaveAWayToThatCornerAtAnyHeading) {
  const Scene scene = RoomWithABench(0.5, 0.5);
  for (double heading = 0; heading < 6.3; heading += 0.1) {
    const Frame<double> frame = FrameOf(Pose<double>{0, 0, heading});
    // So that the room's corner is 0.3 m off its front right corner along both axes.
    const Vec2<double> center = kCorner - frame.ToRoom(0.55, 0.55);
    const Pose<double> pose = {center.x, center.y, heading};
    ASSERT_NEAR(ToCorner(scene, pose), std::hypot(0.3, 0.3), 1e-9);
    EXPECT_EQ(CountOfWays(scene, Slides(scene, pose)), 3) << heading;
  }
}

TEST(SlidesOffCorners, AreNotMadeForACornerThatIsFarEnough) {
  const Scene scene = RoomWithABench(1.2, 0.4);
  const Pose<double> pose = {3.5 + 0.6, 2 - 0.5 - 0.2, 0};
  ASSERT_GT(ToCorner(scene, pose), kWay_m);
  EXPECT_EQ(CountOfWays(scene, Slides(scene, pose)), 0);
}

TEST(SlidesOffCorners, ThereAreNoneInARectangle) {
  Scene scene = RoomWithABench(1.2, 0.4);
  scene.room = RectangularRoom(6, 5);
  EXPECT_TRUE(Slides(scene, {1, 0.5, 0}).empty());
}

TEST(Candidates, WhatHangsIsTriedInTheMiddleOfAWallFirst) {
  Scene scene = RoomWithABench(2, 0.1);
  scene.room = RectangularRoom(6, 5);
  scene.objects[0].kind = ObjectKind::kWall;
  const Layout layout = {{0, 0, 0}};
  Random random(1);
  std::vector<Pose<double>> tried;
  ProposeCandidates({scene, layout, {}, {}, {}}, 0, {}, random, tried);
  ASSERT_FALSE(tried.empty());
  EXPECT_NEAR(scene.room.walls[0].Offset(Center(tried[0])), scene.room.walls[0].length_m / 2, 1e-9);
}

}  // namespace
}  // namespace flair::optimizer
