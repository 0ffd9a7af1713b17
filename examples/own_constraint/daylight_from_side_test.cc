// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

// A room of 4 m x 3 m whose window is in the south wall, from x = 1 to x = 2.
double CostOfDesk(const std::string& pose, const std::string& more = "") {
  return CostAt("4x3 room; window south 1 1; desk 1.2x0.6 at " + pose, "daylight_from_side", "object=desk" + more);
}

TEST(DaylightFromSide, ComesFromTheLeftOrFromTheRight) {
  EXPECT_EQ(CostOfDesk("1.5,1.2,90"), 0);
  EXPECT_EQ(CostOfDesk("1.5,1.2,270"), 0);
  EXPECT_GT(CostOfDesk("1.5,1.2,0"), 0.1);
  EXPECT_GT(CostOfDesk("1.5,1.2,180"), 0.1);
}

TEST(DaylightFromSide, ThirtyDegreesAskewIsStillSideways) {
  EXPECT_EQ(CostOfDesk("1.5,1.2,61"), 0);
  EXPECT_GT(CostOfDesk("1.5,1.2,59"), 0);
}

TEST(DaylightFromSide, CostGrowsWithTheSquareOfTheWayToTheWindow) {
  // The side is 0.6 m long, and 0.6 m from the desk's centre.
  EXPECT_EQ(CostOfDesk("2.29,1.2,90"), 0);
  EXPECT_NEAR(CostOfDesk("2.5,1.2,90"), std::pow(2.5 - 0.3 - 2, 2), 1e-12);
  EXPECT_NEAR(CostOfDesk("1.5,2.3,90"), std::pow(2.3 - 0.6 - 1.5, 2), 1e-12);
  EXPECT_NEAR(CostOfDesk("1.5,2.3,90", " max_distance_m=1"), std::pow(2.3 - 0.6 - 1, 2), 1e-12);
}

TEST(DaylightFromSide, TheBestWindowCounts) {
  EXPECT_EQ(CostAt("4x3 room; window north 0 1; window south 1 1; desk 1.2x0.6 at 1.5,1.2,90", "daylight_from_side",
                   "object=desk"),
            0);
}

TEST(DaylightFromSide, ARoomWithoutWindowHasNone) {
  const absl::StatusOr<SceneText> text = ParseScene("4x3 room; desk 1.2x0.6 at 1.5,1.2,90");
  ASSERT_TRUE(text.ok()) << text.status();
  const auto cost = Bind(EdgeFromText("daylight_from_side", "object=desk"), {text->scene, text->zone_centers});
  EXPECT_EQ(cost.status().code(), absl::StatusCode::kFailedPrecondition) << cost.status();
}

}  // namespace
}  // namespace flair::optimizer
