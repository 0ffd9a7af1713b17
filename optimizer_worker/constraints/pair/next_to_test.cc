// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/next_to.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(NextTo, FiveCentimetresOfAirAreNextTo) {
  const auto at = [](const char* x) {
    return CostAt(std::string("5x4 room; stand 0.5x0.4 at ") + x + ",2,0; bed 1.5x2 at 2.25,2,0", "next_to",
                  "object=stand target=bed");
  };
  EXPECT_NEAR(at("1.25"), 0, 1e-12);
  EXPECT_NEAR(at("1.21"), 0, 1e-12);
  EXPECT_NEAR(at("1.1"), 0.01, 1e-12);
  EXPECT_NEAR(at("1.35"), 0.01, 1e-12);
}

TEST(NextTo, SidesMayBeOfAnyLength) {
  for (const char* width : {"0.5", "1", "2", "3"}) {
    const std::string scene = std::string("8x4 room; a ") + width + "x1 at 4,2.5,180; b " + width + "x1 at 4,1.5,0";
    EXPECT_NEAR(CostAt(scene, "next_to", "object=a target=b object_side=front target_side=front"), 0, 1e-12) << width;
  }
}

TEST(NextTo, BodiesOnTheSameSideAreNotNextToEachOther) {
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 2,2,0; b 1x1 at 2,2,0", "next_to",
                     "object=a target=b object_side=left target_side=left"),
              2, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
