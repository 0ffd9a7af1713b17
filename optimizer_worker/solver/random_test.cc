// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/random.h"

#include <gtest/gtest.h>

#include <vector>

namespace flair::optimizer {
namespace {

TEST(Random, IsTheSameOnEveryMachine) {
  Random random(42);
  EXPECT_EQ(random.Next(), 13679457532755275413ull);
  EXPECT_GE(random.Uniform(), 0);
  EXPECT_LT(random.Below(3), 3);
}

TEST(PlaneSequence, CoversTheSquareEvenly) {
  Random random(1);
  PlaneSequence sequence(random);
  std::vector<int> quarters(4, 0);
  for (int i = 0; i < 40; ++i) {
    double x = 0, y = 0;
    sequence.Next(x, y);
    ++quarters[(x < 0.5 ? 0 : 1) + (y < 0.5 ? 0 : 2)];
  }
  for (int count : quarters) EXPECT_NEAR(count, 10, 2);
}

}  // namespace
}  // namespace flair::optimizer
