// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "fmt/format.h"
#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(AgainstWall, CostGrowsWithTheSquareOfTheGap) {
  EXPECT_NEAR(CostAt("4x3 room; desk 1.2x0.6 at 2,0.4,0", "against_wall", "object=desk"), 0.01, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; desk 1.2x0.6 at 2,0.5,0", "against_wall", "object=desk"), 0.04, 1e-12);
}

TEST(AgainstWall, BeyondTheWallIsAsBadAsBeforeIt) {
  EXPECT_NEAR(CostAt("4x3 room; desk 1.2x0.6 at 2,0.2,0", "against_wall", "object=desk"), 0.01, 1e-12);
}

TEST(AgainstWall, TheGapCostsTheSameInARoomOfAnySize) {
  EXPECT_NEAR(CostAt("40x30 room; desk 1.2x0.6 at 12,0.4,0", "against_wall", "object=desk"), 0.01, 1e-12);
}

TEST(AgainstWall, AnAngleCostsOneMinusItsCosine) {
  const double turned = CostAt("4x3 room; desk 1.2x0 at 2,0,60", "against_wall", "object=desk wall=south");
  EXPECT_NEAR(turned, 0.5, 1e-12);
}

TEST(AgainstWall, TheSideMayNotStickOutBeyondAWallsEnd) {
  // The wall from (2,2) to (2,4) of the L is 2 m long; its inner end is a corner that sticks into the room.
  const char* l_shape = "room 0,0 4,0 4,2 2,2 2,4 0,4; bed 1x1 at 1.5,2.3,90";
  EXPECT_NEAR(CostAt(l_shape, "against_wall", "object=bed wall=wall_4"), 0.04, 1e-12);
}

TEST(AgainstWall, AnObliqueWallIsMeasuredAcrossIt) {
  const std::string room = "room 0,0 4,0 4,2 2,4 0,4; ";
  EXPECT_NEAR(CostAt(room + "desk 1.2x0.6 at 2.787868,2.787868,135", "against_wall", "object=desk"), 0, 1e-11);
  EXPECT_NEAR(CostAt(room + "desk 1.2x0.6 at 2.717157,2.717157,135", "against_wall", "object=desk"), 0.01, 1e-6);
  EXPECT_NEAR(CostAt(room + "desk 1.2x0.6 at 2.787868,2.787868,135", "centered_on_wall", "object=desk"), 0, 1e-11);
}

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

constexpr char kLShape[] = "room 0,0 4,0 4,2 2,2 2,4 0,4; ";

TEST(NearWall, ExcessOverTheLimitIsSquared) {
  EXPECT_NEAR(CostAt("6x6 room; sofa 2x1 at 3,1,0", "near_wall", "object=sofa max_distance_m=0.5"), 0, 1e-12);
  EXPECT_NEAR(CostAt("6x6 room; sofa 2x1 at 3,1,0", "near_wall", "object=sofa max_distance_m=0.3"), 0.04, 1e-12);
}

TEST(NearWall, AWallOfAnLShapedRoomIsAWall) {
  EXPECT_NEAR(CostAt(std::string(kLShape) + "sofa 1x0.6 at 3,1.5,180", "near_wall", "object=sofa"), 0, 1e-12);
}

TEST(NearWall, TheLineOfAWallBeyondItsEndIsNotTheWall) {
  EXPECT_GT(CostAt(std::string(kLShape) + "sofa 1x0.6 at 1,1.2,180", "near_wall", "object=sofa"), 0.5);
}

TEST(NearWall, ObliqueWallsAreWalls) {
  EXPECT_NEAR(
      CostAt("room 0,0 4,0 4,2 2,4 0,4; desk 1.2x0.6 at 2.7,2.7,135", "near_wall", "object=desk max_distance_m=0.2"), 0,
      1e-12);
}

TEST(NotAgainstWall, EveryCornerTooNearCounts) {
  EXPECT_NEAR(CostAt("6x6 room; table 1x1 at 3,0.6,0", "not_against_wall", "object=table"), 2 * 0.01, 1e-12);
  EXPECT_NEAR(CostAt("6x6 room; table 1x1 at 3,0.7,0", "not_against_wall", "object=table"), 0, 1e-12);
}

TEST(NotAgainstWall, BeyondTheWallIsWorseThanAtIt) {
  EXPECT_GT(CostAt("6x6 room; table 1x1 at 3,0.3,0", "not_against_wall", "object=table"),
            CostAt("6x6 room; table 1x1 at 3,0.5,0", "not_against_wall", "object=table"));
}

TEST(NotAgainstWall, ACornerThatSticksIntoTheRoomIsKeptAwayFrom) {
  // It is the end of two walls; each is sqrt(0.02) m away.
  const double excess = 0.2 - std::sqrt(0.02);
  EXPECT_NEAR(CostAt("room 0,0 4,0 4,2 2,2 2,4 0,4; table 1x1 at 1.4,1.4,0", "not_against_wall", "object=table"),
              2 * excess * excess, 1e-12);
}

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

double CostOfHeading(const std::string& room, double heading_deg) {
  return CostAt(fmt::format("{}; table 1x0.8 at 1.5,1.5,{}", room, heading_deg), "parallel_to_wall", "object=table");
}

TEST(ParallelToWall, EveryQuarterTurnIsFineInARectangle) {
  for (double heading_deg : {0, 90, 180, 270, 360}) EXPECT_NEAR(CostOfHeading("4x3 room", heading_deg), 0, 1e-15);
}

TEST(ParallelToWall, NearAWallsDirectionTheCostIsTheSquaredAngle) {
  const double angle_rad = std::acos(-1.0) / 180;
  for (double heading_deg : {1, 91, 179, 269}) {
    EXPECT_NEAR(CostOfHeading("4x3 room", heading_deg), angle_rad * angle_rad, 1e-6) << heading_deg;
  }
  EXPECT_NEAR(CostOfHeading("4x3 room", 45), 0.25, 1e-12);
}

TEST(ParallelToWall, AnObliqueWallWillDo) {
  const std::string room = "room 0,0 4,0 4,2 2,4 0,4";
  for (double heading_deg : {0, 45, 90, 135, 225}) EXPECT_NEAR(CostOfHeading(room, heading_deg), 0, 1e-15);
  EXPECT_NEAR(CostOfHeading(room, 22.5), 0.125, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
