// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/pair/between.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

double Between(const std::string& object_at, const std::string& neighbours = "first=b second=c") {
  return CostAt("6x4 room; a 1x0.6 at " + object_at + "; b 0.5x0.5 at 1,2,0; c 0.5x0.5 at 5,2,90", "between",
                "object=a " + neighbours);
}

TEST(Between, HoldsOnTheLineWhateverTheHeadings) {
  for (const char* at : {"3,2,0", "2,2,90", "4,2,45", "3,2.15,10"}) EXPECT_NEAR(Between(at), 0, 1e-12) << at;
}

TEST(Between, OffsetBeyondAQuarterOfTheShorterSideIsSquared) { EXPECT_NEAR(Between("3,2.5,0"), 0.1225, 1e-12); }

TEST(Between, BeyondANeighbourIsNotBetween) { EXPECT_NEAR(Between("0.5,2,0"), 0.64, 1e-12); }

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

}  // namespace
}  // namespace flair::optimizer
