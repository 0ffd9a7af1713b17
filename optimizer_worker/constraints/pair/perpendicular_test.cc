// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/perpendicular.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double Perpendicular(const std::string& heading_deg) {
  return CostAt("6x6 room; a 1x1 at 1,1," + heading_deg + "; b 1x1 at 4,4,0", "perpendicular", "object=a target=b");
}

TEST(Perpendicular, RightAnglesToEitherSideCostNothing) {
  for (const char* heading : {"90", "270", "-90", "450"}) EXPECT_NEAR(Perpendicular(heading), 0, 1e-12) << heading;
}

TEST(Perpendicular, CostIsTheSquaredCosine) {
  EXPECT_NEAR(Perpendicular("0"), 1, 1e-12);
  EXPECT_NEAR(Perpendicular("180"), 1, 1e-12);
  EXPECT_NEAR(Perpendicular("45"), 0.5, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
