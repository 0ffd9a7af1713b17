// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/against_wall.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace flair::optimizer
