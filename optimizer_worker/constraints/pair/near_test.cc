// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/near.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double Near(const std::string& distance_m, const std::string& b_at = "4,1,0") {
  return CostAt("6x6 room; a 1x1 at 1,1,0; b 1x1 at " + b_at, "near", "object=a target=b max_distance_m=" + distance_m);
}

TEST(Near, MeasuresFromSideToSide) {
  EXPECT_NEAR(Near("2"), 0, 1e-12);
  EXPECT_NEAR(Near("1.5"), 0.25, 1e-12);
}

TEST(Near, MeasuresFromCornerToCornerAcross) {
  // The gap is the diagonal of 1.5 m by 2 m.
  EXPECT_NEAR(Near("1.5", "3.5,4,0"), 1, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
