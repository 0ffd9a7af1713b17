// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/geometry/footprint.h"

#include <gtest/gtest.h>

#include "room/geometry/angle.h"

namespace flair {
namespace {

TEST(Footprint, CornersRunCounterClockwiseFromTheBackLeft) {
  const auto c = Corners(Footprint{2, 1}, Pose<double>{5, 5, 0});
  EXPECT_EQ(c[0], (Vec2<double>{4, 4.5}));
  EXPECT_EQ(c[2], (Vec2<double>{6, 5.5}));
}

TEST(Footprint, AQuarterTurnPutsTheBackToTheEast) {
  const SideEdge<double> back = EdgeOf(Footprint{2, 1}, Pose<double>{0, 0, kPi / 2}, Side::kBack);
  EXPECT_NEAR(back.outward_normal.x, 1, 1e-15);
  EXPECT_NEAR(back.Middle().x, 0.5, 1e-15);
}

TEST(Footprint, ObjectFrameAndRoomFrameAreInverse) {
  const Frame<double> frame = FrameOf(Pose<double>{1, 2, 0.7});
  const Vec2<double> p = frame.ToObject(frame.ToRoom(0.3, -0.4));
  EXPECT_NEAR(p.x, 0.3, 1e-15);
  EXPECT_NEAR(p.y, -0.4, 1e-15);
}

TEST(Angle, WrapsIntoHalfOpenRanges) {
  EXPECT_NEAR(WrapAngle(3 * kPi), -kPi, 1e-12);
  EXPECT_EQ(WrapHeading(-1e-20), 0);
  EXPECT_NEAR(AngleBetween(0.1, kTwoPi - 0.1), 0.2, 1e-12);
  EXPECT_NEAR(HeadingOf({-1, 0}), kPi / 2, 1e-15);
}

TEST(Footprint, NamesOfSidesAndCornersReadBack) {
  for (Side side : kSides) EXPECT_EQ(SideFromName(SideName(side)), side);
  EXPECT_FALSE(SideFromName("top").has_value());
  EXPECT_EQ(CornerFromName("front_left"), Corner::kFrontLeft);
}

}  // namespace
}  // namespace flair
