// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/on_wall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(OnWall, AFullTurnOnTheSouthWallCostsNothing) {
  EXPECT_NEAR(CostAt("4x3 room; art 0.6x0.04 at 1,0.02,360 wall", "on_wall", "object=art"), 0, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; art 0.6x0.04 at 0.02,1,-90 wall", "on_wall", "object=art"), 0, 1e-12);
}

TEST(OnWall, SlidesOffAWindowTheShorterWay) {
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; art 0.6x0.04 at 0.8,0.02,0 wall height 0.5 elevation 1.3", "on_wall",
                     "object=art"),
              0.01, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
