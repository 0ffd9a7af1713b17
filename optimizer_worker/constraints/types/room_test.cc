// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/measure/floor_shape.h"
#include "optimizer_worker/constraints/measure/hanging.h"
#include "optimizer_worker/constraints/testing/cost_at.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {
namespace {

TEST(DoorClear, OnlyTheRealSwingIsBlocked) {
  // Hinged at 1 m, 0.9 m wide: the leaf stands open along x = 1; beside the strike only the passage matters.
  EXPECT_NEAR(CostAt("4x3 room; door south 1 0.9; box 0.3x0.3 at 0.85,0.5,0", "door_clear", "object=box"), 0, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; door south 1 0.9; box 0.2x0.2 at 1.85,0.85,0", "door_clear", "object=box"), 0, 1e-12);
  EXPECT_GT(CostAt("4x3 room; door south 1 0.9; box 0.2x0.2 at 1.2,0.8,0", "door_clear", "object=box"), 0.001);
}

TEST(DoorClear, TheWayOutNeverLeadsThroughTheWall) {
  // 0.1 m deep at the wall in the middle of the passage: 0.5 m sideways or into the room, not 0.1 m back.
  EXPECT_GT(CostAt("4x3 room; door south 1 1 outward; box 0.1x0.1 at 1.5,0.05,0", "door_clear", "object=box"), 0.25);
}

TEST(DoorClear, DoorsThatDoNotSwingInNeedThePassageOnly) {
  for (const char* leaf : {"outward", "sliding", "open"}) {
    const std::string room = std::string("4x3 room; door south 1 0.9 ") + leaf;
    EXPECT_NEAR(CostAt(room + "; box 1x0.5 at 1.4,0.9,0", "door_clear", "object=box"), 0, 1e-12);
    EXPECT_NEAR(CostAt(room + "; box 1x0.5 at 1.4,0.8,0", "door_clear", "object=box"), 0.0025, 1e-12);
  }
}

TEST(InBounds, CostIsTheSquaredExcessOfTheCorners) {
  EXPECT_NEAR(CostAt("4x3 room; box 1x1 at 0.4,1,0", "in_bounds", "object=box"), 2 * 0.01, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; box 1x1 at 0.4,0.3,0", "in_bounds", "object=box"), 2 * 0.01 + 2 * 0.04, 1e-12);
}

TEST(InBounds, TheNotchOfAnLIsOutside) {
  const std::string room = "room 0,0 4,0 4,2 2,2 2,4 0,4; ";
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.5,2.5,0", "in_bounds", "object=box"), 0, 1e-12);
  // 0.1 m over the wall at x = 2.
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.6,3,0", "in_bounds", "object=box"), 0.01, 1e-9);
  // Over the inner corner: the nearer way out counts.
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.7,1.9,0", "in_bounds", "object=box"), 0.04, 1e-9);
  // A turned box that clears the inner corner with all four corners on the floor.
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.4,1.4,45", "in_bounds", "object=box"), 0, 1e-12);
}

TEST(InBounds, AnInnerCornerInsideTheObjectCountsEvenWhenAllItsCornersAreInside) {
  EXPECT_GT(CostAt("room 0,0 4,0 4,2 2,2 2,4 0,4; box 2.4x0.4 at 1.9,1.9,315", "in_bounds", "object=box"), 0.001);
}

TEST(InBounds, ThinPiersAreOutsideToo) {
  const std::string room = "room 0,0 1.9,0 1.9,2 2.1,2 2.1,0 4,0 4,3 0,3; ";
  EXPECT_GT(CostAt(room + "box 1x1 at 2,0.7,0", "in_bounds", "object=box"), 0.1);
  EXPECT_NEAR(CostAt(room + "box 1x0.9 at 2,2.5,0", "in_bounds", "object=box"), 0, 1e-12);
}

TEST(NoOverlap, CostIsTheSquaredPenetrationDepth) {
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.9,1.3,0", "no_overlap", "object=a other=b"), 0.01, 1e-12);
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.3,1.9,90", "no_overlap", "object=a other=b"), 0.01, 1e-12);
}

TEST(NoOverlap, TouchingCostsNothingAndHasNoJump) {
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 2,1,0", "no_overlap", "object=a other=b"), 0, 1e-15);
  EXPECT_LT(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.999,1,0", "no_overlap", "object=a other=b"), 1.1e-6);
}

TEST(NoOverlap, RugsCarriersAndOtherHeightsAreExempt) {
  const auto text = ParseScene(
      "5x4 room; rug 2x2 at 2,2,0 rug; desk 1x0.6 at 2,0.3,0 height 0.75; lamp 0.2x0.2 at 2,0.3,0 surface on desk "
      "height 0.4;"
      "art 0.6x0.05 at 2,0,0 wall height 0.5 elevation 1.4; shelf 1x0.3 at 2,0.15,0 height 2; bulb 0.5x0.5 at 2,1,0 "
      "ceiling "
      "height 0.5 elevation 2.4; screen 0.5x0.1 at 2,0.2,0 surface on desk height 0.4; bin 0.3x0.3 at 2,0.3,0 on desk "
      "height 0.4; rail 0.6x0.1 at 2,0.05,0 wall on shelf height 1.2 elevation 0.9");
  ASSERT_TRUE(text.ok());
  const Scene& scene = text->scene;
  const auto collide = [&scene](const char* a, const char* b) {
    return CanCollide(scene, scene.IndexOf(a), scene.IndexOf(b));
  };
  EXPECT_FALSE(collide("rug", "desk"));
  EXPECT_FALSE(collide("lamp", "desk"));
  EXPECT_FALSE(collide("art", "desk"));
  EXPECT_FALSE(collide("bulb", "shelf"));
  EXPECT_FALSE(collide("lamp", "shelf"));
  EXPECT_TRUE(collide("art", "shelf"));
  EXPECT_TRUE(collide("desk", "shelf"));
  EXPECT_TRUE(collide("lamp", "screen"));
  // Two pieces on the floor, whatever is said about one carrying the other.
  EXPECT_TRUE(collide("bin", "desk"));
  // What hangs above a piece and belongs to it does not hang in it.
  EXPECT_TRUE(collide("rail", "shelf"));
}

TEST(OnWall, AFullTurnOnTheSouthWallCostsNothing) {
  EXPECT_NEAR(CostAt("4x3 room; art 0.6x0.04 at 1,0.02,360 wall", "on_wall", "object=art"), 0, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; art 0.6x0.04 at 0.02,1,-90 wall", "on_wall", "object=art"), 0, 1e-12);
}

TEST(OnWall, SlidesOffAWindowTheShorterWay) {
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; art 0.6x0.04 at 0.8,0.02,0 wall height 0.5 elevation 1.3", "on_wall",
                     "object=art"),
              0.01, 1e-12);
}

TEST(OnWall, KeepsOutOfTheWayOfADoorsLeaf) {
  const std::string door = "4x3 room; door south 0.1 0.8; ";
  // The open leaf stands 0.1 m off the west wall and is 0.8 m long: the shelf, up to y = 0.2, has 0.6 m to go.
  EXPECT_NEAR(CostAt(door + "shelf 0.6x0.2 at 0.1,0.5,270 wall height 0.3 elevation 1.5", "on_wall", "object=shelf"),
              0.36, 0.01);
  EXPECT_NEAR(CostAt(door + "art 0.6x0.08 at 0.04,0.5,270 wall height 0.3 elevation 1.5", "on_wall", "object=art"), 0,
              1e-12);
  EXPECT_NEAR(CostAt(door + "shelf 0.6x0.2 at 0.1,0.5,270 wall height 0.3 elevation 2.2", "on_wall", "object=shelf"), 0,
              1e-12);
}

TEST(NoOverlap, KeepsThingsOffTheOpeningOfWhatTheyStandOn) {
  const auto cost = [](const std::string& thing) {
    return CostAt("4x3 room; basin 1x0.6 at 2,1,0 height 0.85 rim 0.2 0.1; " + thing, "no_overlap",
                  "object=thing other=basin");
  };
  EXPECT_NEAR(cost("thing 0.2x0.2 at 1.7,1,0 surface on basin height 0.3"), 0.01, 1e-12);
  EXPECT_NEAR(cost("thing 0.2x0.2 at 1.6,1,0 surface on basin height 0.3"), 0, 1e-12);
  const auto text = ParseScene(
      "4x3 room; basin 1x0.6 at 2,1,0 height 0.85 rim 0.2 0.1; duck 0.1x0.1 at 2,1,0 surface on basin elevation -0.1; "
      "board 0.5x0.3 at 2,1,0 surface on basin");
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(NoOverlapPair(text->scene, 1, 0), nullptr) << "is meant to be in it";
  EXPECT_EQ(NoOverlapPair(text->scene, 2, 0), nullptr) << "lies across it";
}

}  // namespace
}  // namespace flair::optimizer
