// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/not_facing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double NotFacing(const std::string& heading_deg) {
  return CostAt("6x6 room; a 1x1 at 3,3," + heading_deg + "; b 1x1 at 3,5,0", "not_facing", "object=a target=b");
}

TEST(NotFacing, StraightAheadIsFurthestOff) {
  const double most = (1 - std::sqrt(0.5)) * (1 - std::sqrt(0.5));
  EXPECT_NEAR(NotFacing("0"), most, 1e-12);
  EXPECT_NEAR(NotFacing("360"), most, 1e-12);
}

TEST(NotFacing, HoldsFrom45DegreesOn) {
  EXPECT_GT(NotFacing("40"), 1e-3);
  EXPECT_GT(NotFacing("-40"), 1e-3);
  for (const char* heading : {"45.001", "90", "180", "270", "314.999"}) EXPECT_NEAR(NotFacing(heading), 0, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
