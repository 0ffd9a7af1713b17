// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/under_window.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(UnderWindow, ADeskAtTheWallUnderTheWindowCostsNothing) {
  for (const char* size : {"1.2x0.5", "0.8x0.5", "2x0.5"}) {
    EXPECT_NEAR(CostAt(std::string("4x3 room; window south 1 1; desk ") + size + " at 1.5,0.25,0", "under_window",
                       "object=desk"),
                0, 1e-12)
        << size;
  }
}

TEST(UnderWindow, AnySideMayLookAtTheWall) {
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,0.6,90", "under_window", "object=desk"), 0,
              1e-12);
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,0.3,180", "under_window", "object=desk"), 0,
              1e-12);
}

TEST(UnderWindow, AWindowInAnInnerWallOfAnLShapedRoom) {
  const std::string room = "room 0,0 4,0 4,2 2,2 2,4 0,4; window wall_3 0.5 1; ";
  EXPECT_NEAR(CostAt(room + "desk 0.8x0.5 at 3,1.75,180", "under_window", "object=desk"), 0, 1e-12);
  EXPECT_GT(CostAt(room + "desk 0.8x0.5 at 1,1.75,180", "under_window", "object=desk"), 0.5);
}

}  // namespace
}  // namespace flair::optimizer
