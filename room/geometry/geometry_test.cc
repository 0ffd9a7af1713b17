// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair {
namespace {

const Polygon kL{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}};
const Polygon kSquare{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

TEST(Polygon, AreaAndCentroidOfAnL) {
  EXPECT_EQ(Area(kL), 12);
  EXPECT_NEAR(Centroid(kL).x, (8 * 2 + 4 * 1) / 12.0, 1e-12);
}

TEST(Polygon, ContainsItsBoundaryAndNotTheNotch) {
  for (Vec2<double> p : {Vec2<double>{1, 1}, {2, 3}, {0, 0}, {4, 1}, {3, 2}, {2, 2}})
    EXPECT_TRUE(Contains(kL, p)) << p.x << p.y;
  for (Vec2<double> p : {Vec2<double>{3, 3}, {-0.1, 1}, {2.0001, 2.0001}, {5, 2}})
    EXPECT_FALSE(Contains(kL, p)) << p.x << p.y;
}

TEST(Polygon, SignedDistanceIsNegativeInTheNotch) {
  EXPECT_NEAR(SignedDistance(kL, {3, 2.5}), -0.5, 1e-12);
  EXPECT_NEAR(SignedDistance(kL, {1, 3}), 1, 1e-12);
}

TEST(Polygon, CrossedAndFlatOutlinesAreNotSimple) {
  EXPECT_TRUE(IsSimple(kL));
  EXPECT_FALSE(IsSimple({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}));
  EXPECT_FALSE(IsSimple({{{0, 0}, {2, 0}, {1, 0}}}));
  EXPECT_FALSE(IsSimple({{{0, 0}, {2, 0}, {1, 0}, {1, 1}}}));
}

TEST(Polygon, TrianglesCoverThePolygonExactly) {
  double sum = 0;
  for (const Polygon& triangle : Triangulate(kL)) {
    EXPECT_GT(SignedArea(triangle.vertices), 0);
    sum += Area(triangle);
  }
  EXPECT_NEAR(sum, 12, 1e-12);
}

TEST(Polygon, IntersectionAreaAgreesWithCounting) {
  std::mt19937_64 random(7);
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int round = 0; round < 20; ++round) {
    const double x = uniform(), y = uniform(), r = 0.3 + uniform() / 2;
    const Polygon diamond{{{x - r, y}, {x, y - r}, {x + r, y}, {x, y + r}}};
    int hits = 0;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps; ++j) hits += Contains(diamond, {(i + 0.5) / kSteps, (j + 0.5) / kSteps});
    }
    EXPECT_NEAR(ConvexIntersectionArea(kSquare.vertices, diamond.vertices), hits / double(kSteps * kSteps), 0.01);
  }
}

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
