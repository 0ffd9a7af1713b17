// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/not_in_corner.h"

#include <gtest/gtest.h>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(NotInCorner, CostIsTheSquareOfWhatLacksToTheFartherWall) {
  EXPECT_NEAR(CostAt("4x3 room; pool 1x1 at 0.6,0.5,0", "not_in_corner", "object=pool"), 0.25 * 0.25, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; pool 1x1 at 0.6,0.75,0", "not_in_corner", "object=pool"), 0.1 * 0.1, 1e-12);
}

TEST(NotInCorner, OneWallMayBeTouchedAnywhereElse) {
  for (const char* pose : {"2,0.5,0", "2,2.5,180", "0.5,1.5,270", "0.86,0.5,0", "3.5,0.86,90"}) {
    EXPECT_EQ(CostAt(std::string("4x3 room; pool 1x1 at ") + pose, "not_in_corner", "object=pool"), 0) << pose;
  }
}

TEST(NotInCorner, EveryCornerCounts) {
  for (const char* pose : {"0.5,0.5,0", "3.5,0.5,90", "3.5,2.5,180", "0.5,2.5,270"}) {
    EXPECT_NEAR(CostAt(std::string("4x3 room; pool 1x1 at ") + pose, "not_in_corner", "object=pool"), 0.35 * 0.35, 1e-9)
        << pose;
  }
}

TEST(NotInCorner, OfAnObjectAsWideAsTheRoomBothEndsCount) {
  EXPECT_NEAR(CostAt("1x3 room; pool 1x1 at 0.5,0.5,0", "not_in_corner", "object=pool"), 2 * 0.35 * 0.35, 1e-9);
}

TEST(NotInCorner, ACornerThatSticksIntoTheRoomIsNone) {
  const std::string room = "room 0,0 4,0 4,2 2,2 2,4 0,4; ";
  EXPECT_EQ(CostAt(room + "pool 0.5x0.5 at 1.7,1.7,0", "not_in_corner", "object=pool"), 0);
  EXPECT_GT(CostAt(room + "pool 0.5x0.5 at 3.7,1.7,0", "not_in_corner", "object=pool"), 0.08);
  EXPECT_GT(CostAt(room + "pool 0.5x0.5 at 1.7,3.7,0", "not_in_corner", "object=pool"), 0.08);
}

}  // namespace
}  // namespace flair::optimizer
