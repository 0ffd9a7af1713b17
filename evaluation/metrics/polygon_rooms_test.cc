// SPDX-License-Identifier: GPL-3.0-or-later
// A rectangle may begin at any corner and may have vertices in the middle of its sides: its measures stay the same.
#include <gtest/gtest.h>

#include <string>

#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/testing/furnished.h"
#include "evaluation/metrics/testing/oor_paper.h"
#include "evaluation/metrics/walk_grid.h"

namespace flair::evaluation {
namespace {

// In the door's swing, in each other, beyond a wall, and with a narrow way in between.
const std::string kFurniture =
    "; bed 1.6x2 at 1.2,4.1,180; desk 1.2x0.6 at 3.75,2,90; chair 0.5x0.5 at 3.4,2.1,-70; carpet 2x1 at 2,2.5,0 rug; "
    "shelf 0.9x0.4 at 1.6,0.7,30; wardrobe 1.5x0.6 at 3.2,4.6,180";

void ExpectSameMeasures(const std::string& room) {
  const Furnished rectangle("4x5 room; door south 0.8 0.9" + kFurniture);
  const Furnished polygon(room + kFurniture);
  const LayoutView expected = rectangle.view(), actual = polygon.view();
  EXPECT_GT(OobPercent(expected), 0);
  EXPECT_GT(OorPercent(expected), 0);
  EXPECT_NEAR(OobPercent(actual), OobPercent(expected), 1e-12) << room;
  EXPECT_NEAR(OorPercent(actual), OorPercent(expected), 1e-12) << room;
  EXPECT_NEAR(OorPaperPercent(actual), OorPaperPercent(expected), 1e-12) << room;
  EXPECT_NEAR(DeepestOverlap_m(actual), DeepestOverlap_m(expected), 1e-12) << room;
  EXPECT_EQ(MeasureReach(actual).floor_share, MeasureReach(expected).floor_share) << room;
  EXPECT_EQ(MeasureReach(actual).blocked, MeasureReach(expected).blocked) << room;
  // The samples on the walls lie elsewhere when a side is divided.
  EXPECT_NEAR(PathwayCost_m3(actual), PathwayCost_m3(expected), 0.02 * PathwayCost_m3(expected)) << room;
}

TEST(PolygonRooms, ARectangleMayBeginAtAnyCorner) {
  ExpectSameMeasures("room 4,0 4,5 0,5 0,0; door south 0.8 0.9");
  ExpectSameMeasures("room 4,5 0,5 0,0 4,0; door south 0.8 0.9");
  ExpectSameMeasures("room 0,5 0,0 4,0 4,5; door south 0.8 0.9");
}

TEST(PolygonRooms, VerticesInTheMiddleOfASideChangeNothing) {
  ExpectSameMeasures("room 0,0 2.5,0 4,0 4,5 0,5; door wall_1 0.8 0.9");
  ExpectSameMeasures("room 0,0 4,0 4,1.3 4,2.9 4,5 1.1,5 0,5; door wall_1 0.8 0.9");
  ExpectSameMeasures("room 2.5,5 0,5 0,0 0.5,0 4,0 4,5; door wall_4 0.3 0.9");
}

// An L turned by 90 degrees about the origin with all that stands in it.
TEST(PolygonRooms, TurningAnLRoomChangesNoArea) {
  const Furnished upright(
      "room 0,0 4,0 4,2 2,2 2,4 0,4; door wall_1 1 0.9; desk 1x0.6 at 2.1,2.2,0; chair 0.5x0.5 at 1.7,2,20");
  const Furnished turned(
      "room 0,0 0,4 -2,4 -2,2 -4,2 -4,0; door wall_1 1 0.9; desk 1x0.6 at -2.2,2.1,90; chair 0.5x0.5 at -2,1.7,110");
  EXPECT_GT(OobPercent(upright.view()), 0);
  EXPECT_NEAR(OobPercent(turned.view()), OobPercent(upright.view()), 1e-12);
  EXPECT_GT(OorPercent(upright.view()), 0);
  EXPECT_NEAR(OorPercent(turned.view()), OorPercent(upright.view()), 1e-12);
  EXPECT_NEAR(DeepestOverlap_m(turned.view()), DeepestOverlap_m(upright.view()), 1e-12);
}

}  // namespace
}  // namespace flair::evaluation
