// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/in_front_of.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(InFrontOf, TheGapIsMeasuredFromFrontToNearestCorner) {
  const auto at = [](const char* y) {
    return CostAt(std::string("5x5 room; table 1x0.6 at 2,") + y + ",0; sofa 2x1 at 2,1,0", "in_front_of",
                  "object=table target=sofa distance_m=0.4");
  };
  EXPECT_NEAR(at("2.2"), 0, 1e-12);
  EXPECT_NEAR(at("2.0"), 0, 1e-12);
  EXPECT_NEAR(at("2.3"), 0.01, 1e-12);
  EXPECT_NEAR(at("1.9"), 0.01, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
