// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/near_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

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

}  // namespace
}  // namespace flair::optimizer
