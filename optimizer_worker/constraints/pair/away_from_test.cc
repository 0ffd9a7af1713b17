// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/away_from.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double AwayFrom(const std::string& distance_m, const std::string& b_at = "4,1,0") {
  return CostAt("6x6 room; a 1x1 at 1,1,0; b 1x1 at " + b_at, "away_from",
                "object=a target=b min_distance_m=" + distance_m);
}

TEST(AwayFrom, MeasuresFromSideToSide) {
  EXPECT_NEAR(AwayFrom("2"), 0, 1e-12);
  EXPECT_NEAR(AwayFrom("2.5"), 0.25, 1e-12);
}

TEST(AwayFrom, MeasuresFromCornerToCornerAcross) {
  // The gap is the diagonal of 1.5 m by 2 m.
  EXPECT_NEAR(AwayFrom("3", "3.5,4,0"), 0.25, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
