// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/clear_of_feature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(ClearOfFeature, ALowPieceMayStandUnderTheSill) {
  const std::string room = "4x3 room; window south 1 1 sill 0.9; ";
  EXPECT_EQ(CostAt(room + "desk 1x0.6 at 1.5,0.3,0 height 0.9", "clear_of_feature", "object=desk feature=window"), 0);
  EXPECT_GT(CostAt(room + "desk 1x0.6 at 1.5,0.3,0 height 0.91", "clear_of_feature", "object=desk feature=window"),
            0.1);
  // Of unknown height: it might be tall.
  EXPECT_GT(CostAt(room + "desk 1x0.6 at 1.5,0.3,0", "clear_of_feature", "object=desk feature=window"), 0.1);
}

TEST(ClearOfFeature, CostIsTheSquareOfTheShortestWayOut) {
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; shelf 1x0.4 at 2.4,0.2,0 height 2", "clear_of_feature",
                     "object=shelf feature=window"),
              0.01, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
