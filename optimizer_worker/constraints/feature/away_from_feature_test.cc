// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/feature/away_from_feature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(AwayFromFeature, MeasuresFromTheRectangleToTheOpening) {
  EXPECT_NEAR(CostAt("6x4 room; door south 1 1; box 1x1 at 4,0.5,0", "away_from_feature",
                     "object=box feature=door min_distance_m=1.7"),
              0.04, 1e-12);
}

TEST(AwayFromFeature, PushesThingsThatStandInTheOpeningIntoTheRoom) {
  const auto text = ParseScene("6x4 room; window south 1 1; box 0.4x0.4 at 1.5,0.2,0");
  ASSERT_TRUE(text.ok());
  const auto cost = Bind(EdgeFromText("away_from_feature", "object=box feature=window"), {text->scene, {}});
  ASSERT_TRUE(cost.ok());
  double gradient[3];
  EXPECT_GT((*cost)->Gradient(text->layout, gradient), 3.9);
  EXPECT_LT(gradient[1], -1);
}

}  // namespace
}  // namespace flair::optimizer
