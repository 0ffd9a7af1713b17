// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/metrics/testing/furnished.h"
#include "evaluation/metrics/walk_grid.h"

namespace flair::evaluation {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

double Length(const Route& route) {
  double length = 0;
  for (size_t i = 1; i < route.points.size(); ++i) length += Norm(route.points[i] - route.points[i - 1]);
  return length;
}

// The nearest that any point of the route comes to the box of an object, metres.
double Clearance(const LayoutView& view, const Route& route, size_t object) {
  const Footprint& footprint = view.scene.objects[object].footprint;
  const Frame<double> frame = FrameOf(view.layout[object]);
  double least = 1e9;
  for (size_t i = 1; i < route.points.size(); ++i) {
    for (int k = 0; k <= 100; ++k) {
      const Vec2<double> p = route.points[i - 1] + (k / 100.0) * (route.points[i] - route.points[i - 1]);
      const Vec2<double> local = frame.ToObject(p);
      least = std::min(least, std::hypot(std::max(0.0, std::abs(local.x) - footprint.width_m / 2),
                                         std::max(0.0, std::abs(local.y) - footprint.depth_m / 2)));
    }
  }
  return least;
}

TEST(Routes, GoStraightFromTheDoorWhereNothingStandsInTheWay) {
  // The wardrobe stands against the far wall and looks back at the door.
  const Furnished room("4x5 room; door south 1.5 1; wardrobe 1x0.6 at 2,4.7,180");
  const Routes routes = FindRoutes(room.view());
  ASSERT_EQ(routes.routes.size(), 1u);
  EXPECT_EQ(routes.routes[0].object_id, "wardrobe");
  EXPECT_THAT(routes.blocked, IsEmpty());
  EXPECT_NEAR(routes.routes[0].points.front().x, 2, 1e-9);
  EXPECT_NEAR(routes.routes[0].points.front().y, 0, 1e-9);
  EXPECT_NEAR(routes.routes[0].points.back().y, 4.4 - 0.3, 0.1);
  EXPECT_NEAR(Length(routes.routes[0]), 4.1, 0.1);
}

TEST(Routes, GoRoundWhatStandsInTheWayAtAPersonsHalfWidth) {
  const Furnished room("4x5 room; door south 1.5 1; wardrobe 1x0.6 at 2,4.7,180; island 2x1 at 2,2.5,0");
  const LayoutView view = room.view();
  const Routes routes = FindRoutes(view);
  ASSERT_EQ(routes.routes.size(), 2u);
  const Route& round = routes.routes[0];
  EXPECT_GT(Length(round), 4.2);
  EXPECT_LT(Length(round), 5.2);
  EXPECT_GE(Clearance(view, round, 1), kPersonRadius_m - 0.05);
}

TEST(Routes, BlockedIsWhatReachCallsBlocked) {
  // A wall of cupboards with a gap of 0.4 m shuts the back of the room off.
  const Furnished room(
      "4x5 room; door south 1.5 1; bed 1x2 at 2,4,180; left 1.8x0.5 at 0.9,2.5,0; right 1.8x0.5 at "
      "3.1,2.5,180");
  const Routes routes = FindRoutes(room.view());
  EXPECT_THAT(routes.blocked, ElementsAre("bed", "left"));
  EXPECT_THAT(MeasureReach(room.view()).blocked, ElementsAre("bed", "left"));
  ASSERT_EQ(routes.routes.size(), 1u);
  EXPECT_EQ(routes.routes[0].object_id, "right");
}

TEST(Routes, WithoutADoorNothingIsWalkedAndNothingIsBlocked) {
  const Routes routes = FindRoutes(Furnished("4x5 room; bed 1x2 at 2,3,0").view());
  EXPECT_THAT(routes.routes, IsEmpty());
  EXPECT_THAT(routes.blocked, IsEmpty());
}

TEST(Routes, RugsAreWalkedOverAndNoGoal) {
  const Routes routes = FindRoutes(Furnished("4x5 room; door south 1.5 1; carpet 3x3 at 2,2,0 rug").view());
  EXPECT_THAT(routes.routes, IsEmpty());
  EXPECT_THAT(routes.blocked, IsEmpty());
}

}  // namespace
}  // namespace flair::evaluation
