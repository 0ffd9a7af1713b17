// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/parallel_to_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fmt/format.h"
#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

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
