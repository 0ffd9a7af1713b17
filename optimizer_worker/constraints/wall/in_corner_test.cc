// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/in_corner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(InCorner, FlushInTheCornerIsBest) {
  EXPECT_NEAR(CostAt("4x3 room; shelf 1x0.5 at 0.5,0.25,0", "in_corner", "object=shelf"), 0, 1e-12);
  EXPECT_GT(CostAt("4x3 room; shelf 1x0.5 at 0.6,0.6,315", "in_corner", "object=shelf"), 0.05);
}

TEST(InCorner, CostIsTheSquaredDistanceOfTheCorners) {
  EXPECT_NEAR(CostAt("4x3 room; shelf 1x0.5 at 0.6,0.45,0", "in_corner", "object=shelf"), 0.01 + 0.04, 1e-12);
}

TEST(InCorner, EveryCornerOfTheRoomWillDo) {
  for (const char* pose : {"0.5,0.25,0", "3.5,0.25,0", "3.75,0.5,90", "3.75,2.5,90", "3.5,2.75,180", "0.25,2.5,270"}) {
    EXPECT_NEAR(CostAt(std::string("4x3 room; shelf 1x0.5 at ") + pose, "in_corner", "object=shelf"), 0, 1e-12) << pose;
  }
}

TEST(InCorner, ACornerThatSticksIntoTheRoomIsNone) {
  EXPECT_GT(CostAt("room 0,0 4,0 4,2 2,2 2,4 0,4; shelf 1x0.5 at 2.5,1.75,180", "in_corner", "object=shelf"), 0.1);
}

TEST(InCorner, TheOuterCornersOfATShapedRoomWillDo) {
  const std::string room = "room 2,0 4,0 4,2 6,2 6,4 0,4 0,2 2,2; ";
  for (const char* pose : {"5.5,2.25,0", "0.25,3.5,270", "2.5,0.25,0"}) {
    EXPECT_NEAR(CostAt(room + "shelf 1x0.5 at " + pose, "in_corner", "object=shelf"), 0, 1e-12) << pose;
  }
  EXPECT_GT(CostAt(room + "shelf 1x0.5 at 4.5,2.25,0", "in_corner", "object=shelf"), 0.1);
}

}  // namespace
}  // namespace flair::optimizer
