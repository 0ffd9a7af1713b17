// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double AwayFrom(const std::string& distance_m, const std::string& b_at = "4,1,0") {
  return CostAt("6x6 room; a 1x1 at 1,1,0; b 1x1 at " + b_at, "away_from",
                "object=a target=b min_distance_m=" + distance_m);
}

TEST(AwayFrom, MeasuresFromSideToSide) {
  EXPECT_NEAR(AwayFrom("2"), 0, 1e-12);
  EXPECT_NEAR(AwayFrom("2.5"), 0.25, 1e-12);
}

TEST(AwayFrom, MeasuresFromCornerToCornerAcross) {
  // The gap is the diagonal of 1.5 m by 2 m.
  EXPECT_NEAR(AwayFrom("3", "3.5,4,0"), 0.25, 1e-12);
}

double Between(const std::string& object_at, const std::string& neighbours = "first=b second=c") {
  return CostAt("6x4 room; a 1x0.6 at " + object_at + "; b 0.5x0.5 at 1,2,0; c 0.5x0.5 at 5,2,90", "between",
                "object=a " + neighbours);
}

TEST(Between, HoldsOnTheLineWhateverTheHeadings) {
  for (const char* at : {"3,2,0", "2,2,90", "4,2,45", "3,2.15,10"}) EXPECT_NEAR(Between(at), 0, 1e-12) << at;
}

TEST(Between, OffsetBeyondAQuarterOfTheShorterSideIsSquared) { EXPECT_NEAR(Between("3,2.5,0"), 0.1225, 1e-12); }

TEST(Between, BesideTheMiddleHalfIsNotBetween) {
  EXPECT_NEAR(Between("0.5,2,0"), 2.25, 1e-12);
  EXPECT_NEAR(Between("1.5,2,0"), 0.25, 1e-12);
}

TEST(Between, NeighboursMayBeNamedInAnyOrder) {
  for (const char* at : {"3,2.5,0", "0.5,2,0", "5.5,3,0"}) {
    EXPECT_NEAR(Between(at), Between(at, "first=c second=b"), 1e-12) << at;
  }
}

TEST(Between, OfThreeOnALineOnlyTheMiddleOneIsBetween) {
  const std::string scene = "6x4 room; a 1x0.6 at 3,2,0; b 0.5x0.5 at 1,2,0; c 0.5x0.5 at 5,2,90";
  EXPECT_NEAR(CostAt(scene, "between", "object=a first=b second=c"), 0, 1e-12);
  EXPECT_GT(CostAt(scene, "between", "object=b first=c second=a"), 1);
  EXPECT_GT(CostAt(scene, "between", "object=c first=a second=b"), 1);
}

TEST(Between, NothingIsBetweenTwoInOnePlace) {
  EXPECT_NEAR(CostAt("6x4 room; a 1x0.6 at 2,2,0; b 0.5x0.5 at 1,2,0; c 0.5x0.5 at 1,2,0", "between",
                     "object=a first=b second=c"),
              1 + 0.09, 1e-12);
}

TEST(Facing, WithinTheStripOfItsWidthAllIsFaced) {
  for (const char* x : {"2.5", "3", "3.5"}) {
    EXPECT_NEAR(CostAt(std::string("6x6 room; a 1x1 at 3,1,0; b 1x1 at ") + x + ",4,0", "facing", "object=a target=b"),
                0, 1e-12);
  }
}

TEST(Facing, TwiceTheExcessOverTheStripIsSquared) {
  EXPECT_NEAR(CostAt("6x6 room; a 1x1 at 3,1,0; b 1x1 at 3.7,4,0", "facing", "object=a target=b"), 0.16, 1e-12);
}

TEST(Facing, WhatIsBehindIsNotFaced) {
  const double difference = std::hypot(0.5, 2.5) - std::hypot(0.5, 1.5);
  EXPECT_NEAR(CostAt("6x6 room; a 1x1 at 3,3,0; b 1x1 at 3,1,0", "facing", "object=a target=b"),
              2 * difference * difference, 1e-12);
}

TEST(Facing, BothFaceEachOther) {
  const std::string scene = "6x6 room; a 1x1 at 3,1,0; b 1x1 at 3,4,";
  EXPECT_NEAR(CostAt(scene + "180", "facing", "object=a target=b both=true"), 0, 1e-12);
  EXPECT_GT(CostAt(scene + "0", "facing", "object=a target=b both=true"), 4);
}

TEST(InFrontOf, TheGapIsMeasuredFromFrontToNearestCorner) {
  const auto at = [](const char* y) {
    return CostAt(std::string("5x5 room; table 1x0.6 at 2,") + y + ",0; sofa 2x1 at 2,1,0", "in_front_of",
                  "object=table target=sofa distance_m=0.4");
  };
  EXPECT_NEAR(at("2.2"), 0, 1e-12);
  EXPECT_NEAR(at("2.0"), 0, 1e-12);
  EXPECT_NEAR(at("2.3"), 0.01, 1e-12);
  EXPECT_NEAR(at("1.9"), 0.01, 1e-12);
}

double Near(const std::string& distance_m, const std::string& b_at = "4,1,0") {
  return CostAt("6x6 room; a 1x1 at 1,1,0; b 1x1 at " + b_at, "near", "object=a target=b max_distance_m=" + distance_m);
}

TEST(Near, MeasuresFromSideToSide) {
  EXPECT_NEAR(Near("2"), 0, 1e-12);
  EXPECT_NEAR(Near("1.5"), 0.25, 1e-12);
}

TEST(Near, MeasuresFromCornerToCornerAcross) {
  // The gap is the diagonal of 1.5 m by 2 m.
  EXPECT_NEAR(Near("1.5", "3.5,4,0"), 1, 1e-12);
}

TEST(NextTo, FiveCentimetresOfAirAreNextTo) {
  const auto at = [](const char* x) {
    return CostAt(std::string("5x4 room; stand 0.5x0.4 at ") + x + ",2,0; bed 1.5x2 at 2.25,2,0", "next_to",
                  "object=stand target=bed");
  };
  EXPECT_NEAR(at("1.25"), 0, 1e-12);
  EXPECT_NEAR(at("1.21"), 0, 1e-12);
  EXPECT_NEAR(at("1.1"), 0.01, 1e-12);
  EXPECT_NEAR(at("1.35"), 0.01, 1e-12);
}

TEST(NextTo, SidesMayBeOfAnyLength) {
  for (const char* width : {"0.5", "1", "2", "3"}) {
    const std::string scene = std::string("8x4 room; a ") + width + "x1 at 4,2.5,180; b " + width + "x1 at 4,1.5,0";
    EXPECT_NEAR(CostAt(scene, "next_to", "object=a target=b object_side=front target_side=front"), 0, 1e-12) << width;
  }
}

TEST(NextTo, BodiesOnTheSameSideAreNotNextToEachOther) {
  EXPECT_NEAR(CostAt("5x4 room; a 1x1 at 2,2,0; b 1x1 at 2,2,0", "next_to",
                     "object=a target=b object_side=left target_side=left"),
              2, 1e-12);
}

double NotFacing(const std::string& heading_deg) {
  return CostAt("6x6 room; a 1x1 at 3,3," + heading_deg + "; b 1x1 at 3,5,0", "not_facing", "object=a target=b");
}

TEST(NotFacing, StraightAheadIsFurthestOff) {
  const double most = (1 - std::sqrt(0.5)) * (1 - std::sqrt(0.5));
  EXPECT_NEAR(NotFacing("0"), most, 1e-12);
  EXPECT_NEAR(NotFacing("360"), most, 1e-12);
}

TEST(NotFacing, HoldsFrom45DegreesOn) {
  EXPECT_GT(NotFacing("40"), 1e-3);
  EXPECT_GT(NotFacing("-40"), 1e-3);
  for (const char* heading : {"45.001", "90", "180", "270", "314.999"}) EXPECT_NEAR(NotFacing(heading), 0, 1e-12);
}

double Parallel(const std::string& a_deg, const std::string& b_deg) {
  return CostAt("6x6 room; a 1x1 at 1,1," + a_deg + "; b 1x1 at 4,4," + b_deg, "parallel", "object=a target=b");
}

TEST(Parallel, HeadingsAreComparedAcrossTheFullTurn) {
  EXPECT_NEAR(Parallel("359.9999", "0.0001"), 0, 1e-10);
  EXPECT_NEAR(Parallel("720", "0"), 0, 1e-12);
  EXPECT_NEAR(Parallel("-90", "270"), 0, 1e-12);
}

TEST(Parallel, CostIsOneMinusTheCosine) {
  EXPECT_NEAR(Parallel("60", "0"), 0.5, 1e-12);
  EXPECT_NEAR(Parallel("90", "0"), 1, 1e-12);
}

TEST(Parallel, TheOppositeWayIsFurthestOff) { EXPECT_NEAR(Parallel("180", "0"), 2, 1e-12); }

double Perpendicular(const std::string& heading_deg) {
  return CostAt("6x6 room; a 1x1 at 1,1," + heading_deg + "; b 1x1 at 4,4,0", "perpendicular", "object=a target=b");
}

TEST(Perpendicular, RightAnglesToEitherSideCostNothing) {
  for (const char* heading : {"90", "270", "-90", "450"}) EXPECT_NEAR(Perpendicular(heading), 0, 1e-12) << heading;
}

TEST(Perpendicular, CostIsTheSquaredCosine) {
  EXPECT_NEAR(Perpendicular("0"), 1, 1e-12);
  EXPECT_NEAR(Perpendicular("180"), 1, 1e-12);
  EXPECT_NEAR(Perpendicular("45"), 0.5, 1e-12);
}

}  // namespace
}  // namespace flair::optimizer
