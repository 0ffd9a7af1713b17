// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/testing/furnished.h"
#include "evaluation/metrics/walk_grid.h"

namespace flair::evaluation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Oob, IsTheAreaOutsideInPercentOfTheRoom) {
  // 0.1 m of a 1 m wide desk is beyond the south wall of a 20 m² room.
  EXPECT_NEAR(OobPercent(Furnished("4x5 room; desk 1x0.6 at 2,0.2,0").view()), 100 * 0.1 / 20, 1e-9);
  EXPECT_NEAR(OobPercent(Furnished("4x5 room; desk 1x0.6 at 2,0.3,0").view()), 0, 1e-12);
}

TEST(Oob, KnowsTheNotchOfARoomThatIsNotConvex) {
  const std::string room = "room 0,0 4,0 4,2 2,2 2,4 0,4; ";
  EXPECT_NEAR(OobPercent(Furnished(room + "desk 1x1 at 1,3,0").view()), 0, 1e-9);
  EXPECT_NEAR(OobPercent(Furnished(room + "desk 1x1 at 2,2.5,0").view()), 100 * 0.5 / 12, 1e-9);
}

TEST(Oor, CountsPairsOfFurnitureOnce) {
  EXPECT_NEAR(OorPercent(Furnished("4x5 room; a 1x1 at 2,2,0; b 1x1 at 2.5,2,0").view()), 100 * 0.5 / 20, 1e-9);
  EXPECT_NEAR(OorPercent(Furnished("4x5 room; a 1x1 at 2,2,0; b 1x1 at 3,2,0").view()), 0, 1e-12);
}

TEST(Oor, RugsCollideWithNothing) {
  EXPECT_EQ(OorPercent(Furnished("4x5 room; carpet 2x2 at 2,2,0 rug; b 1x1 at 2,2,0").view()), 0);
}

TEST(Oor, WallObjectsCollideOnlyAtTheSameHeight) {
  const std::string high = "4x5 room; a 1x0.1 at 2,0.05,0 wall tertiary height 0.5 elevation 1.8; ";
  EXPECT_EQ(OorPercent(Furnished(high + "b 1x0.1 at 2,0.05,0 wall tertiary height 0.5 elevation 1").view()), 0);
  EXPECT_NEAR(OorPercent(Furnished(high + "b 1x0.1 at 2,0.05,0 wall tertiary height 0.5 elevation 1.5").view()),
              100 * 0.1 / 20, 1e-9);
}

TEST(Oor, WhatHangsOnAWallObjectDoesNotCollideWithIt) {
  const std::string shelf = "4x5 room; shelf 1x0.2 at 2,0.1,0 wall tertiary height 0.4 elevation 1.5; ";
  EXPECT_GT(OorPercent(Furnished(shelf + "lamp 0.1x0.1 at 2,0.1,0 wall tertiary height 0.3 elevation 1.6").view()), 0);
  EXPECT_EQ(
      OorPercent(Furnished(shelf + "lamp 0.1x0.1 at 2,0.1,0 wall tertiary height 0.3 elevation 1.6 on shelf").view()),
      0);
}

TEST(Oor, AWallObjectOverAWindowCountsAtTheWindowsHeight) {
  const std::string room = "4x5 room; window south 1.5 1 sill 0.9 head 2; ";
  EXPECT_NEAR(OorPercent(Furnished(room + "a 1x0.1 at 2,0.05,0 wall tertiary height 0.5 elevation 1").view()),
              100 * 0.1 / 20, 1e-9);
  EXPECT_EQ(OorPercent(Furnished(room + "a 1x0.1 at 2,0.05,0 wall tertiary height 0.5 elevation 2.2").view()), 0);
}

TEST(Oor, APictureDoesNotHangBehindAWardrobe) {
  const std::string picture = "4x5 room; art 0.5x0.05 at 2,0.025,0 wall tertiary height 0.5 elevation 1.4; ";
  EXPECT_NEAR(OorPercent(Furnished(picture + "wardrobe 1x0.6 at 2,0.3,0 height 2").view()), 100 * 0.5 * 0.05 / 20,
              1e-9);
  EXPECT_EQ(OorPercent(Furnished(picture + "dresser 1x0.6 at 2,0.3,0 height 0.9").view()), 0);
  EXPECT_EQ(OorPercent(Furnished(picture + "bookcase 1x0.4 at 2,0.2,0 height 1.405").view()), 0);
  EXPECT_EQ(OorPercent(Furnished(picture + "wardrobe 1x0.6 at 2,0.36,0 height 2").view()), 0);
}

TEST(Oor, TheDoorsSwingIsASectorNotASquare) {
  const std::string room = "4x5 room; door south 1 1; ";
  // A quarter disc of radius 1 around (1, 0).
  EXPECT_NEAR(OorPercent(Furnished(room + "a 1x1 at 1.5,0.5,0").view()), 100 * std::numbers::pi / 4 / 20, 0.002);
  EXPECT_EQ(OorPercent(Furnished(room + "a 0.2x0.2 at 1.9,0.9,0").view()), 0);
  EXPECT_EQ(OorPercent(Furnished("4x5 room; door south 1 1 outward; a 1x1 at 1.5,0.5,0").view()), 0);
}

TEST(FindOverlaps, NamesBoth) {
  const std::vector<Overlap> overlaps = FindOverlaps(Furnished("4x5 room; a 1x1 at 2,2,0; b 1x1 at 2.5,2,0").view());
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_EQ(overlaps[0].first, "a");
  EXPECT_EQ(overlaps[0].second, "b");
}

TEST(Reach, AnEmptyRoomIsReachedButForItsCorners) {
  const Reach reach = MeasureReach(Furnished("4x5 room; door south 1 0.9").view());
  EXPECT_GT(reach.floor_share, 0.99);
  EXPECT_EQ(reach.front_share, 1);
}

TEST(Reach, AGapOfSixtyCentimetresLetsAPersonThrough) {
  const std::string room = "4x5 room; door south 1 0.9 outward; desk 1x0.5 at 1,4.75,180; ";
  const Reach open = MeasureReach(Furnished(room + "shelf 3.4x0.4 at 1.7,2.5,0").view());
  EXPECT_THAT(open.blocked, IsEmpty());
  EXPECT_GT(open.floor_share, 0.9);
  const Reach closed = MeasureReach(Furnished(room + "shelf 3.5x0.4 at 1.75,2.5,180").view());
  EXPECT_THAT(closed.blocked, ElementsAre("desk"));
  EXPECT_LT(closed.floor_share, 0.6);
}

TEST(Reach, AWardrobeThatLooksAtTheWallIsBlocked) {
  const Reach reach = MeasureReach(Furnished("4x5 room; door south 1 0.9; wardrobe 1.5x0.6 at 2,4.7,0").view());
  EXPECT_THAT(reach.blocked, ElementsAre("wardrobe"));
  EXPECT_EQ(reach.front_share, 0);
}

TEST(Reach, EverythingIsStoodAtFromItsFrontOnly) {
  const std::string room = "4x5 room; door south 1 0.9; table 1x1 at 2,4.45,0; ";
  EXPECT_THAT(MeasureReach(Furnished(room).view()).blocked, ElementsAre("table"));
  const Reach turned = MeasureReach(Furnished("4x5 room; door south 1 0.9; table 1x1 at 2,4.45,180").view());
  EXPECT_THAT(turned.blocked, IsEmpty());
}

TEST(Reach, ObjectsThatAreNotPlacedAreNotInTheWay) {
  const Furnished room("4x5 room; door south 1 0.9; shelf 4x0.4 at 2,2.5,0");
  const LayoutView view = room.view();
  EXPECT_LT(MeasureReach(view).floor_share, 0.6);
  const LayoutView without(view.scene, view.layout, std::vector<bool>{false});
  EXPECT_GT(MeasureReach(without).floor_share, 0.99);
}

}  // namespace
}  // namespace flair::evaluation
