// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/in_bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(InBounds, CostIsTheSquaredExcessOfTheCorners) {
  EXPECT_NEAR(CostAt("4x3 room; box 1x1 at 0.4,1,0", "in_bounds", "object=box"), 2 * 0.01, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; box 1x1 at 0.4,0.3,0", "in_bounds", "object=box"), 2 * 0.01 + 2 * 0.04, 1e-12);
}

TEST(InBounds, TheNotchOfAnLIsOutside) {
  const std::string room = "room 0,0 4,0 4,2 2,2 2,4 0,4; ";
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.5,2.5,0", "in_bounds", "object=box"), 0, 1e-12);
  // 0.1 m over the wall at x = 2.
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.6,3,0", "in_bounds", "object=box"), 0.01, 1e-9);
  // Over the inner corner: the nearer way out counts.
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.7,1.9,0", "in_bounds", "object=box"), 0.04, 1e-9);
  // A turned box that clears the inner corner with all four corners on the floor.
  EXPECT_NEAR(CostAt(room + "box 1x1 at 1.4,1.4,45", "in_bounds", "object=box"), 0, 1e-12);
}

TEST(InBounds, AnInnerCornerInsideTheObjectCountsEvenWhenAllItsCornersAreInside) {
  EXPECT_GT(CostAt("room 0,0 4,0 4,2 2,2 2,4 0,4; box 2.4x0.4 at 1.9,1.9,315", "in_bounds", "object=box"), 0.001);
}

TEST(InBounds, ThinPiersAreOutsideToo) {
  const std::string room = "room 0,0 1.9,0 1.9,2 2.1,2 2.1,0 4,0 4,3 0,3; ";
  EXPECT_GT(CostAt(room + "box 1x1 at 2,0.7,0", "in_bounds", "object=box"), 0.1);
  EXPECT_NEAR(CostAt(room + "box 1x0.9 at 2,2.5,0", "in_bounds", "object=box"), 0, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
