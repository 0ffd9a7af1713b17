// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/autodiff/dual.h"

#include <gtest/gtest.h>

namespace flair {
namespace {

// Uses every operation once.
template <typename T>
T Everything(const T& x, const T& y) {
  using std::abs;
  using std::atan2;
  using std::cos;
  using std::sin;
  using std::sqrt;
  T sum = x * y + x / y - sqrt(x * x + 2.0 * y * y + 1.0) + 3.0 - y;
  sum += sin(x) * cos(y) + atan2(y, x);
  sum -= abs(-x) / 2.0;
  return sum + SquaredHinge(x - 0.5) + SquaredOutside(y, -0.2, 0.2);
}

TEST(Dual, AgreesWithCentralDifferencesForEveryOperation) {
  const double step = 1e-6;
  for (double x : {-1.3, -0.4, 0.7, 2.1}) {
    for (double y : {-1.7, -0.3, 0.9}) {
      const Dual<2> d = Everything(Dual<2>::Variable(x, 0), Dual<2>::Variable(y, 1));
      EXPECT_EQ(d.value, Everything(x, y));
      EXPECT_NEAR(d.partial[0], (Everything(x + step, y) - Everything(x - step, y)) / (2 * step), 1e-7)
          << x << " " << y;
      EXPECT_NEAR(d.partial[1], (Everything(x, y + step) - Everything(x, y - step)) / (2 * step), 1e-7)
          << x << " " << y;
    }
  }
}

TEST(Smooth, LengthOfTheZeroVectorHasZeroSlope) {
  const Vec2<Dual<1>> zero{Dual<1>::Variable(0, 0), Dual<1>(0)};
  EXPECT_EQ(Length(zero).value, 0);
  EXPECT_EQ(Length(zero).partial[0], 0);
}

}  // namespace
}  // namespace flair
