// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/door_clear.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(DoorClear, OnlyTheRealSwingIsBlocked) {
  // Hinged at 1 m, 0.9 m wide: the leaf stands open along x = 1; beside the strike only the passage matters.
  EXPECT_NEAR(CostAt("4x3 room; door south 1 0.9; box 0.3x0.3 at 0.85,0.5,0", "door_clear", "object=box"), 0, 1e-12);
  EXPECT_NEAR(CostAt("4x3 room; door south 1 0.9; box 0.2x0.2 at 1.85,0.85,0", "door_clear", "object=box"), 0, 1e-12);
  EXPECT_GT(CostAt("4x3 room; door south 1 0.9; box 0.2x0.2 at 1.2,0.8,0", "door_clear", "object=box"), 0.001);
}

TEST(DoorClear, TheWayOutNeverLeadsThroughTheWall) {
  // 0.1 m deep at the wall in the middle of the passage: 0.5 m sideways or into the room, not 0.1 m back.
  EXPECT_GT(CostAt("4x3 room; door south 1 1 outward; box 0.1x0.1 at 1.5,0.05,0", "door_clear", "object=box"), 0.25);
}

TEST(DoorClear, DoorsThatDoNotSwingInNeedThePassageOnly) {
  for (const char* leaf : {"outward", "sliding", "open"}) {
    const std::string room = std::string("4x3 room; door south 1 0.9 ") + leaf;
    EXPECT_NEAR(CostAt(room + "; box 1x0.5 at 1.4,0.9,0", "door_clear", "object=box"), 0, 1e-12);
    EXPECT_NEAR(CostAt(room + "; box 1x0.5 at 1.4,0.8,0", "door_clear", "object=box"), 0.0025, 1e-12);
  }
}

}  // namespace
}  // namespace flair::optimizer
