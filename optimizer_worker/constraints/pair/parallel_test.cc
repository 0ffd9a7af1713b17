// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/parallel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double Parallel(const std::string& a_deg, const std::string& b_deg) {
  return CostAt("6x6 room; a 1x1 at 1,1," + a_deg + "; b 1x1 at 4,4," + b_deg, "parallel", "object=a target=b");
}

TEST(Parallel, HeadingsAreComparedAcrossTheFullTurn) {
  EXPECT_NEAR(Parallel("359.9999", "0.0001"), 0, 1e-10);
  EXPECT_NEAR(Parallel("720", "0"), 0, 1e-12);
  EXPECT_NEAR(Parallel("-90", "270"), 0, 1e-12);
}

TEST(Parallel, CostIsOneMinusTheCosine) {
  EXPECT_NEAR(Parallel("60", "0"), 0.5, 1e-12);
  EXPECT_NEAR(Parallel("90", "0"), 1, 1e-12);
}

TEST(Parallel, TheOppositeWayIsFurthestOff) { EXPECT_NEAR(Parallel("180", "0"), 2, 1e-12); }

}  // namespace
}  // namespace flair::optimizer
