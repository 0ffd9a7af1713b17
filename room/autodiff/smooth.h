// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks of costs whose derivatives stay finite everywhere.
#pragma once

#include <cmath>

#include "room/autodiff/dual.h"
#include "room/geometry/vec2.h"

namespace flair {

template <typename T>
T Square(const T& x) {
  return x * x;
}

// max(x, 0): slope 0 at 0.
template <typename T>
T Positive(const T& x) {
  return ValueOf(x) > 0 ? x : T(0.0);
}

// max(x, 0)^2: continuously differentiable.
template <typename T>
T SquaredHinge(const T& x) {
  return ValueOf(x) > 0 ? x * x : T(0.0);
}

// How far x is outside [low, high], squared.
template <typename T>
T SquaredOutside(const T& x, double low, double high) {
  return SquaredHinge(T(low) - x) + SquaredHinge(x - T(high));
}

// |x| with slope 0 at 0.
template <typename T>
T Magnitude(const T& x) {
  return ValueOf(x) < 0 ? -x : ValueOf(x) > 0 ? x : T(0.0);
}

// Length of a vector. Its derivative at the zero vector is taken as 0.
template <typename T>
T Length(const Vec2<T>& v) {
  using std::sqrt;
  const T squared = SquaredNorm(v);
  return ValueOf(squared) > 0 ? sqrt(squared) : T(0.0);
}

// 0 for equal directions, 2 for opposite ones, of two unit vectors: 1 - cos of the angle between them.
template <typename T>
T Turn(const Vec2<T>& a, const Vec2<T>& b) {
  return T(1.0) - Dot(a, b);
}

// Smooth maximum of a and b: overestimates by at most width / 4, exact when they differ by `width` or more, C1.
template <typename T>
T SmoothMax(const T& a, const T& b, double width) {
  const double difference = ValueOf(a) - ValueOf(b);
  if (difference >= width) return a;
  if (-difference >= width) return b;
  const T rest = T(width) - Magnitude(a - b);
  return (ValueOf(a) > ValueOf(b) ? a : b) + rest * rest * T(1 / (4 * width));
}

// Smooth minimum: underestimates by at most width / 4.
template <typename T>
T SmoothMin(const T& a, const T& b, double width) {
  return -SmoothMax(-a, -b, width);
}

}  // namespace flair
