// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/facing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(Facing, WithinTheStripOfItsWidthAllIsFaced) {
  for (const char* x : {"2.5", "3", "3.5"}) {
    EXPECT_NEAR(CostAt(std::string("6x6 room; a 1x1 at 3,1,0; b 1x1 at ") + x + ",4,0", "facing", "object=a target=b"),
                0, 1e-12);
  }
}

TEST(Facing, TwiceTheExcessOverTheStripIsSquared) {
  EXPECT_NEAR(CostAt("6x6 room; a 1x1 at 3,1,0; b 1x1 at 3.7,4,0", "facing", "object=a target=b"), 0.16, 1e-12);
}

TEST(Facing, WhatIsBehindIsNotFaced) {
  const double difference = std::hypot(0.5, 2.5) - std::hypot(0.5, 1.5);
  EXPECT_NEAR(CostAt("6x6 room; a 1x1 at 3,3,0; b 1x1 at 3,1,0", "facing", "object=a target=b"),
              2 * difference * difference, 1e-12);
}

TEST(Facing, BothFaceEachOther) {
  const std::string scene = "6x6 room; a 1x1 at 3,1,0; b 1x1 at 3,4,";
  EXPECT_NEAR(CostAt(scene + "180", "facing", "object=a target=b both=true"), 0, 1e-12);
  EXPECT_GT(CostAt(scene + "0", "facing", "object=a target=b both=true"), 4);
}

}  // namespace
}  // namespace flair::optimizer
