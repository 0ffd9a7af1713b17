// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/geometry/gap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "optimizer_worker/constraints/measure/floor_shape.h"

namespace flair::optimizer {
namespace {

double Uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

struct Placed {
  Footprint footprint;
  Pose<double> pose;

  Box<double> box() const { return Box<double>(footprint, FrameOf(pose)); }
  Polygon polygon() const {
    const auto corners = Corners(footprint, pose);
    return {{corners.begin(), corners.end()}};
  }
};

Placed RandomBox(std::mt19937_64& random, double extent) {
  return {{Uniform(random, 0.1, 2), Uniform(random, 0.1, 2)},
          {Uniform(random, 0, extent), Uniform(random, 0, extent), Uniform(random, -4, 4)}};
}

double DistanceBetween(const Segment& a, const Segment& b) {
  if (Intersects(a, b)) return 0;
  return std::min({DistanceTo(a, b.start), DistanceTo(a, b.end), DistanceTo(b, a.start), DistanceTo(b, a.end)});
}

double BruteDistance(const Polygon& a, const Polygon& b) {
  double least = 1e300;
  for (size_t i = 0; i < a.vertices.size(); ++i) {
    for (size_t j = 0; j < b.vertices.size(); ++j) least = std::min(least, DistanceBetween(EdgeAt(a, i), EdgeAt(b, j)));
  }
  return least;
}

TEST(Gap, AgreesWithBruteForceAndIsSymmetric) {
  std::mt19937_64 random(21);
  int apart = 0, overlapping = 0;
  for (int round = 0; round < 3000; ++round) {
    const Placed a = RandomBox(random, 3), b = RandomBox(random, 3);
    const double gap = Gap<double>(a.box(), b.box());
    EXPECT_NEAR(gap, Gap<double>(b.box(), a.box()), 1e-12);
    const double shared = ConvexIntersectionArea(a.polygon().vertices, b.polygon().vertices);
    if (gap > 0) {
      ++apart;
      EXPECT_NEAR(gap, BruteDistance(a.polygon(), b.polygon()), 1e-9);
      EXPECT_NEAR(shared, 0, 1e-12);
    } else {
      ++overlapping;
      if (gap < -1e-6) {
        EXPECT_GT(shared, 0);
      }
    }
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(overlapping, 500);
}

TEST(Gap, OfTwoBoxesIsThatOfTheirPolygons) {
  std::mt19937_64 random(24);
  int apart = 0, overlapping = 0, corners = 0;
  for (int round = 0; round < 6000; ++round) {
    Placed a = RandomBox(random, 3), b = RandomBox(random, 3);
    // Of every four one pair is square to the room, one on a grid, and one has a side without length.
    if (round % 4 > 0) a.pose.theta_rad = b.pose.theta_rad = (random() % 4) * 1.5707963267948966;
    if (round % 4 == 2) a.footprint = b.footprint = {1, 0.5};
    if (round % 4 == 2) a.pose.x_m = std::round(2 * a.pose.x_m) / 2, b.pose.x_m = std::round(2 * b.pose.x_m) / 2;
    if (round % 4 == 3) b.footprint.depth_m = 0, b.pose.theta_rad += 0.3;
    const ConvexPiece first(a.polygon());
    const double expected = Gap<double>(first, ConvexPiece(b.polygon()));
    const Witness witness = Deciding(a.box(), b.box(), SeparatingAxis(a.box(), b.box()));
    EXPECT_NEAR(witness.gap_m, expected, 1e-9) << round;
    EXPECT_NEAR(Gap<double>(a.box(), b.box()), expected, 1e-9) << round;
    EXPECT_NEAR(SquaredPenetration<double>(a.box(), b.box()), SquaredHinge(-expected), 1e-9) << round;
    EXPECT_NEAR(SquaredNearness<double>(a.box(), b.box(), 0.7), SquaredHinge(0.7 - expected), 1e-9) << round;
    EXPECT_NEAR(SquaredNearness<double>(a.box(), ConvexPiece(b.polygon()), 0.7), SquaredHinge(0.7 - expected), 1e-9);
    EXPECT_NEAR(SquaredDistanceBeyond<double>(a.box(), b.box(), 0.7), SquaredHinge(expected - 0.7), 1e-9) << round;
    ++(expected > 0 ? apart : overlapping);
    corners += witness.kind == Witness::kVertices;
  }
  EXPECT_GT(apart, 1000);
  EXPECT_GT(overlapping, 1000);
  EXPECT_GT(corners, 300);
}

TEST(Gap, PushingApartByThePenetrationDepthEndsTheOverlap) {
  std::mt19937_64 random(22);
  for (int round = 0; round < 500; ++round) {
    const Placed a = RandomBox(random, 1.5);
    Placed b = RandomBox(random, 1.5);
    const Box<double> fixed = a.box();
    const Witness axis = SeparatingAxis(fixed, b.box());
    if (axis.gap_m >= 0) continue;
    const Vec2<double> out =
        axis.kind == Witness::kEdgeOfFirst ? fixed.normal(axis.first) : -b.box().normal(axis.second);
    b.pose.x_m -= axis.gap_m * out.x;
    b.pose.y_m -= axis.gap_m * out.y;
    EXPECT_NEAR(Gap<double>(fixed, b.box()), 0, 1e-9);
  }
}

TEST(Gap, OfASegmentIsTheDistanceToIt) {
  const ConvexPiece segment(Segment{{0, 0}, {2, 0}});
  const Footprint unit{1, 1};
  EXPECT_NEAR(Gap<double>(Box<double>(unit, FrameOf(Pose<double>{1, 1, 0})), segment), 0.5, 1e-12);
  EXPECT_NEAR(Gap<double>(Box<double>(unit, FrameOf(Pose<double>{3, 1, 0})), segment), std::hypot(0.5, 0.5), 1e-12);
  EXPECT_NEAR(Gap<double>(Box<double>(unit, FrameOf(Pose<double>{1, 0.5, 0})), segment), 0, 1e-12);
}

const std::vector<Polygon> kFloors = {
    {{{0, 0}, {4, 0}, {4, 3}, {0, 3}}},
    {{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}},
    {{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}},
    {{{0, 0}, {1.9, 0}, {1.9, 2}, {2.1, 2}, {2.1, 0}, {4, 0}, {4, 3}, {0, 3}}},
    {{{0, 0}, {3, 0}, {4, 1}, {4, 4}, {1, 4}, {0, 3}}},
    {{{1, 0}, {3, 0}, {3, 1}, {4, 1}, {4, 3}, {3, 3}, {3, 4}, {1, 4}, {1, 3}, {0, 3}, {0, 1}, {1, 1}}},
    {{{0, 0}, {4, 0}, {4, 4}, {2, 1.5}, {0, 4}}},
};

TEST(FloorShape, ExcessIsZeroExactlyForBoxesOnTheFloor) {
  std::mt19937_64 random(23);
  for (size_t k = 0; k < kFloors.size(); ++k) {
    const FloorShape shape(kFloors[k]);
    int inside = 0;
    for (int round = 0; round < 3000; ++round) {
      Placed placed = RandomBox(random, 4);
      if (round % 2 == 0) placed.pose.theta_rad = (random() % 4) * 1.5707963267948966;
      const double on_floor = Area(ClipByConvex(kFloors[k], placed.polygon().vertices));
      const double missing = placed.footprint.area_m2() - on_floor;
      const double excess = shape.SquaredExcess(placed.box());
      if (missing < 1e-9) {
        ++inside;
        EXPECT_LT(excess, 1e-12) << "floor " << k;
      } else if (missing > 1e-4) {
        EXPECT_GT(excess, 1e-10) << "floor " << k << " missing " << missing;
      }
    }
    EXPECT_GT(inside, 100) << "floor " << k;
  }
}

TEST(FloorShape, ARectangleHasFourHalfPlanesAndNoPockets) {
  const FloorShape shape(kFloors[0]);
  EXPECT_EQ(shape.half_planes().size(), 4u);
  EXPECT_TRUE(shape.pockets().empty());
}

}  // namespace
}  // namespace flair::optimizer
