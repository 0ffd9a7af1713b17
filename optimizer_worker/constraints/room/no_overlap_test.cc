// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/room/no_overlap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"
#include "optimizer_worker/constraints/whole_room.h"

namespace flair::optimizer {
namespace {

TEST(NoOverlap, CostIsTheSquaredPenetrationDepth) {
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.9,1.3,0", "no_overlap", "object=a other=b"), 0.01, 1e-12);
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.3,1.9,90", "no_overlap", "object=a other=b"), 0.01, 1e-12);
}

TEST(NoOverlap, TouchingCostsNothingAndHasNoJump) {
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 2,1,0", "no_overlap", "object=a other=b"), 0, 1e-15);
  EXPECT_LT(CostAt("5x4 room; a 1x1 at 1,1,0; b 1x1 at 1.999,1,0", "no_overlap", "object=a other=b"), 1.1e-6);
}

TEST(NoOverlap, RugsCarriersAndOtherHeightsAreExempt) {
  const auto text = ParseScene(
      "5x4 room; rug 2x2 at 2,2,0 rug; desk 1x0.6 at 2,0.3,0 height 0.75; lamp 0.2x0.2 at 2,0.3,0 surface on desk "
      "height 0.4;"
      "art 0.6x0.05 at 2,0,0 wall height 0.5 elevation 1.4; shelf 1x0.3 at 2,0.15,0 height 2; bulb 0.5x0.5 at 2,1,0 "
      "ceiling "
      "height 0.5 elevation 2.4; screen 0.5x0.1 at 2,0.2,0 surface on desk height 0.4; bin 0.3x0.3 at 2,0.3,0 on desk "
      "height 0.4");
  ASSERT_TRUE(text.ok());
  const Scene& scene = text->scene;
  const auto collide = [&scene](const char* a, const char* b) {
    return CanCollide(scene, scene.IndexOf(a), scene.IndexOf(b));
  };
  EXPECT_FALSE(collide("rug", "desk"));
  EXPECT_FALSE(collide("lamp", "desk"));
  EXPECT_FALSE(collide("art", "desk"));
  EXPECT_FALSE(collide("bulb", "shelf"));
  EXPECT_FALSE(collide("lamp", "shelf"));
  EXPECT_TRUE(collide("art", "shelf"));
  EXPECT_TRUE(collide("desk", "shelf"));
  EXPECT_TRUE(collide("lamp", "screen"));
  // Two pieces on the floor, whatever is said about one carrying the other.
  EXPECT_TRUE(collide("bin", "desk"));
}

}  // namespace
}  // namespace flair::optimizer
