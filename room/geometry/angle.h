// SPDX-License-Identifier: GPL-3.0-or-later
// Angles in radians, counter-clockwise; heading 0 faces +y (north).
#pragma once

#include <cmath>
#include <numbers>

#include "room/geometry/vec2.h"

namespace flair {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTwoPi = 2 * std::numbers::pi;

// The same angle in [-pi, pi).
inline double WrapAngle(double angle_rad) {
  const double turns = std::floor((angle_rad + kPi) / kTwoPi);
  const double wrapped = angle_rad - turns * kTwoPi;
  if (wrapped >= kPi) return wrapped - kTwoPi;
  return wrapped < -kPi ? wrapped + kTwoPi : wrapped;
}

// The same angle in [0, 2 pi).
inline double WrapHeading(double angle_rad) {
  const double wrapped = angle_rad - std::floor(angle_rad / kTwoPi) * kTwoPi;
  return wrapped < 0 || wrapped >= kTwoPi ? 0.0 : wrapped;
}

// Least absolute difference of two angles, [0, pi].
inline double AngleBetween(double a_rad, double b_rad) { return std::abs(WrapAngle(a_rad - b_rad)); }

// Heading whose front is `direction` (any length but zero).
inline double HeadingOf(const Vec2<double>& direction) { return std::atan2(-direction.x, direction.y); }

}  // namespace flair
