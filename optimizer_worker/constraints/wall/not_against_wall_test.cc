// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/wall/not_against_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

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

}  // namespace
}  // namespace flair::optimizer
