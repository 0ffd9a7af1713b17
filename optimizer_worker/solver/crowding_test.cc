// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "optimizer_worker/solver/search.h"

namespace flair::optimizer {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

double CostOf(const std::vector<evaluation::Obstacle>& obstacles) {
  return CrowdingCost_m3(RectangularRoom(6, 5), obstacles);
}

TEST(Crowding, AWayOfSixtyCentimetresCostsNothing) {
  EXPECT_EQ(CostOf({{{2, 2, 0}, {1, 1}}, {{3.6, 2, 0}, {1, 1}}}), 0);
  EXPECT_EQ(CostOf({{{1.1, 1.1, 0}, {1, 1}}}), 0);
}

TEST(Crowding, TouchingCostsNothing) {
  EXPECT_EQ(CostOf({{{2, 2, 0}, {1, 1}}, {{3, 2.2, 0}, {1, 1}}}), 0);
  EXPECT_EQ(CostOf({{{0.5, 2, 0}, {1, 1}}}), 0);
}

TEST(Crowding, AGapCostsItsCrossSectionTimesItsLength) {
  // 0.2 m wide: 2 * 0.01 + 1 * 0.04 on each side, on a length of 0.7 m.
  EXPECT_NEAR(CostOf({{{2, 2, 0}, {1, 1}}, {{3.2, 2.3, 0}, {1, 1}}}), 2 * 0.7 * 0.06, 1e-12);
  // Beside a wall only one side is furniture.
  EXPECT_NEAR(CostOf({{{0.6, 2, kQuarter}, {1, 0.8}}}), 1.0 * 0.06, 1e-12);
}

TEST(Crowding, HeadingsTurnTheFootprints) {
  EXPECT_NEAR(CostOf({{{2, 2, 0}, {1, 1}}, {{3, 2, kQuarter}, {0.6, 0.6}}}),
              CostOf({{{2, 2, 0}, {1, 1}}, {{3, 2, 0}, {0.6, 0.6}}}), 1e-12);
  EXPECT_NEAR(CostOf({{{2, 2, 3 * kQuarter}, {0.4, 1}}, {{3, 2, 0}, {0.6, 0.6}}}),
              CostOf({{{2, 2, 0}, {1, 0.4}}, {{3, 2, 0}, {0.6, 0.6}}}), 1e-12);
}

TEST(Crowding, CrookedNeighboursDoNotCount) { EXPECT_EQ(CostOf({{{2, 2, 0}, {1, 1}}, {{3.3, 2, 0.7}, {1, 1}}}), 0); }

}  // namespace
}  // namespace flair::optimizer
