// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/constraints/testing/cost_at.h"

namespace flair::optimizer {
namespace {

TEST(Surround, OrderInTheListDoesNotMatter) {
  const std::string scene =
      "6x6 room; table 1.6x0.9 at 3,3,0; a 0.5x0.5 at 3,2.2,0; b 0.5x0.5 at 3.1,3.9,180; c 0.5x0.5 at 1.9,3,270;"
      "d 0.5x0.5 at 4.2,3,90";
  const double cost = CostAt(scene, "surround", "center=table objects=a,b,c,d");
  for (const char* order : {"b,a,d,c", "c,d,a,b", "d,c,b,a"}) {
    EXPECT_NEAR(CostAt(scene, "surround", std::string("center=table objects=") + order), cost, 1e-12);
  }
}

TEST(Surround, SixSeatsTakeBothLongSidesTwice) {
  EXPECT_NEAR(CostAt("6x6 room; t 1.6x0.9 at 3,3,0; a 0.5x0.5 at 2.6,2.25,0; b 0.5x0.5 at 3.4,2.25,0; c 0.5x0.5 at "
                     "2.6,3.75,180; d 0.5x0.5 at 3.4,3.75,180; e 0.5x0.5 at 1.9,3,270; f 0.5x0.5 at 4.1,3,90",
                     "surround", "center=t objects=a,b,c,d,e,f"),
              0, 1e-12);
}

TEST(Surround, ASideAtTheWallSeatsNobody) {
  // The back of the table is at the wall: three sides are left for three seats.
  EXPECT_NEAR(CostAt("6x6 room; t 1.6x0.9 at 3,0.45,0; a 0.5x0.5 at 3,1.2,180; b 0.5x0.5 at 1.9,0.45,270; c 0.5x0.5 at "
                     "4.1,0.45,90",
                     "surround", "center=t objects=a,b,c"),
              0, 1e-12);
}

TEST(Surround, SeatsFaceTheTable) {
  EXPECT_NEAR(CostAt("6x6 room; t 1.6x0.9 at 3,3,0; a 0.5x0 at 3,2.55,0; b 0.5x0 at 3,3.45,0", "surround",
                     "center=t objects=a,b"),
              2, 1e-12);
}

TEST(Surround, OneSeatTakesAnySide) {
  for (const char* at : {"3,2.3,0", "3,3.7,180", "1.95,3,270", "4.05,3,90"}) {
    EXPECT_NEAR(
        CostAt(std::string("6x6 room; t 1.6x0.9 at 3,3,0; a 0.5x0.5 at ") + at, "surround", "center=t objects=a"), 0,
        1e-12)
        << at;
  }
}

TEST(Surround, AGapBeyondTenCentimetresIsSquared) {
  EXPECT_NEAR(CostAt("6x6 room; t 1.6x0.9 at 3,3,0; a 0.5x0.5 at 3,4,180", "surround", "center=t objects=a"), 0.04,
              1e-12);
}

}  // namespace
}  // namespace flair::optimizer
