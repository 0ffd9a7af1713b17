// SPDX-License-Identifier: GPL-3.0-or-later
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

TEST(UnderWindow, ADeskAtTheWallUnderTheWindowCostsNothing) {
  for (const char* size : {"1.2x0.5", "0.8x0.5", "2x0.5"}) {
    EXPECT_NEAR(CostAt(std::string("4x3 room; window south 1 1; desk ") + size + " at 1.5,0.25,0", "under_window",
                       "object=desk"),
                0, 1e-12)
        << size;
  }
}

TEST(UnderWindow, AnySideMayLookAtTheWall) {
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,0.6,90", "under_window", "object=desk"), 0,
              1e-12);
  EXPECT_NEAR(CostAt("4x3 room; window south 1 1; desk 1.2x0.6 at 1.5,0.3,180", "under_window", "object=desk"), 0,
              1e-12);
}

TEST(UnderWindow, AWindowInAnInnerWallOfAnLShapedRoom) {
  const std::string room = "room 0,0 4,0 4,2 2,2 2,4 0,4; window wall_3 0.5 1; ";
  EXPECT_NEAR(CostAt(room + "desk 0.8x0.5 at 3,1.75,180", "under_window", "object=desk"), 0, 1e-12);
  EXPECT_GT(CostAt(room + "desk 0.8x0.5 at 1,1.75,180", "under_window", "object=desk"), 0.5);
}

}  // namespace
}  // namespace flair::optimizer
