// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "evaluation/metrics/layout_metrics.h"
#include "evaluation/metrics/measures.h"
#include "evaluation/metrics/testing/furnished.h"
#include "fmt/format.h"

namespace flair::evaluation {
namespace {

double PathwayOf(const std::string& text) { return PathwayCost_m3(Furnished(text).view()); }

TEST(Ways, AnEmptyCorridorHasItsMiddleLine) {
  double length = 0;
  for (const WayPiece& piece : FindWays(Furnished("6x1 room").view())) {
    length += piece.weighted_length_m;

    const double corner = std::min(piece.middle.x, 6 - piece.middle.x);
    if (corner > 0.3) EXPECT_NEAR(piece.middle.y, 0.5, 0.2) << piece.middle.x;
  }
  // The middle line is 5 m long from centre to centre of the two ends; little of the branches into the corners counts.
  EXPECT_NEAR(length, 5, 0.4);
}

TEST(Ways, LeadThroughDoorsButNotThroughWalls) {
  const auto reaches_wall = [](const std::string& text) {
    for (const WayPiece& piece : FindWays(Furnished(text).view())) {
      if (piece.middle.y < 0.15 && piece.weighted_length_m > 1e-3 && std::abs(piece.middle.x - 1.95) < 0.3) return true;
    }
    return false;
  };
  EXPECT_TRUE(reaches_wall("4x3 room; door south 1.5 0.9"));
  EXPECT_FALSE(reaches_wall("4x3 room"));
}

TEST(Ways, StayOnTheFloorAndOutsideOfFurniture) {
  const Furnished room(
      "room 0,0 4,0 4,2 2,2 2,4 0,4; door wall_1 2.5 0.9; bed 1.6x2 at 0.9,2.9,180; carpet 1x1 at 3,1,0 rug");
  for (const WayPiece& piece : FindWays(room.view())) {
    EXPECT_FALSE(piece.middle.x > 2 && piece.middle.y > 2);
    EXPECT_FALSE(std::abs(piece.middle.x - 0.9) < 0.8 && std::abs(piece.middle.y - 2.9) < 1.0);
  }
}

TEST(Pathway, WideWaysCostNothing) {
  EXPECT_LT(PathwayOf("4x4 room; door south 0.5 0.9; bed 1.6x2 at 2.5,3,180"), 5e-3);
}

TEST(Pathway, ANarrowWayCostsItsLengthTimesItsCrossSection) {
  // Two blocks 0.3 m apart over 2 m: twice (2 * 0.05^2 + 0.15^2) along the gap.
  const double wide = PathwayOf("6x4 room; a 2x2 at 1,2,0; b 2x2 at 5,2,0");
  const double narrow = PathwayOf("6x4 room; a 2x2 at 1.85,2,0; b 2x2 at 4.15,2,0");
  EXPECT_NEAR(narrow - wide, 2 * 2 * (2 * 0.05 * 0.05 + 0.15 * 0.15), 0.03);
}

TEST(Pathway, TouchingFurnitureHasNoWayInBetween) {
  EXPECT_LT(PathwayOf("6x4 room; a 2x2 at 2,2,0; b 2x2 at 4,2,0"),
            0.2 * PathwayOf("6x4 room; a 2x2 at 1.95,2,0; b 2x2 at 4.05,2,0"));
}

TEST(Pathway, RugsAreWalkedOver) {
  EXPECT_EQ(PathwayOf("4x4 room; door south 1 0.9; carpet 2x2 at 2,2,0 rug"), PathwayOf("4x4 room; door south 1 0.9"));
}

TEST(Pathway, IsTheSameToTheLastBitEachTime) {
  const char* const room = "4x4 room; door south 0.5 0.9; bed 1.6x2 at 1.2,3,180; desk 1.2x0.6 at 3.7,2,90";
  const double cost = PathwayOf(room);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(PathwayOf(room), cost);
}

TEST(Pathway, AMirroredRoomCostsTheSame) {
  const double cost = PathwayOf("4x4 room; door south 0.5 0.9; bed 1.6x2 at 1.2,3,180; desk 1.2x0.6 at 3.7,2,90");
  const double mirrored = PathwayOf("4x4 room; door south 2.6 0.9; bed 1.6x2 at 2.8,3,180; desk 1.2x0.6 at 0.3,2,-90");
  EXPECT_NEAR(mirrored, cost, 0.02 * cost);
}

TEST(Pathway, AMillimetreChangesLittle) {
  double before = 0;
  for (int step = 0; step <= 40; ++step) {
    const double x = 1.0 + 0.001 * step;
    const double cost =
        PathwayOf(fmt::format("4x4 room; door south 0.5 0.9; bed 1.6x2 at {},3,180; chair 0.5x0.5 at 2.3,2.2,0", x));
    if (step > 0) EXPECT_NEAR(cost, before, 0.012 + 0.1 * before) << x;
    before = cost;
  }
}

TEST(DeepestOverlap, IsTheShortestPushThatParts) {
  EXPECT_EQ(DeepestOverlap_m(Furnished("4x4 room; a 1x1 at 1,1,0; b 1x1 at 2,1,0").view()), 0);
  EXPECT_NEAR(DeepestOverlap_m(Furnished("4x4 room; a 1x1 at 1,1,0; b 1x1 at 1.9,1.3,0").view()), 0.1, 1e-12);
  EXPECT_NEAR(DeepestOverlap_m(Furnished("4x4 room; a 1x1 at 0.4,1,0").view()), 0.1, 1e-12);
  EXPECT_NEAR(DeepestOverlap_m(Furnished("4x4 room; door south 1 0.9; a 1x1 at 1.5,1.3,0").view()), 0.1, 2e-3);
  EXPECT_EQ(DeepestOverlap_m(Furnished("4x4 room; carpet 1x1 at 1,1,0 rug; b 1x1 at 1,1,0").view()), 0);
}

}  // namespace
}  // namespace flair::evaluation
