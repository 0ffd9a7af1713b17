// SPDX-License-Identifier: GPL-3.0-or-later
// Forward-mode automatic differentiation: a value with its partial derivatives with respect to N variables. A formula
// templated on its scalar gives the value with double and value and gradient with Dual<N>; both take the same branches,
// because comparisons look at the value only.
#pragma once

#include <array>
#include <cmath>

#include "room/geometry/pose.h"

namespace flair {

// N numbers kept two by two, as every x86-64 and ARM64 adds and multiplies them. Each lane is worked out like a double
// on its own, so that results do not depend on the machine. An odd N has a last lane that stays 0 or is never read.
template <int N>
class Partials {
 public:
  Partials() = default;
  // 1 at `index`, else 0.
  static constexpr Partials Unit(int index) { return At(index, 1); }
  // `value` at `index`, else 0.
  static constexpr Partials At(int index, double value) {
    Partials p;
    for (int i = 0; i < kPairs; ++i) p.pairs_[i] = Pair{index == 2 * i ? value : 0, index == 2 * i + 1 ? value : 0};
    return p;
  }
  double operator[](int i) const { return pairs_[i / 2][i % 2]; }

  // slope * a
  friend Partials Scaled(double slope, const Partials& a) {
    Partials r;
    for (int i = 0; i < kPairs; ++i) r.pairs_[i] = slope * a.pairs_[i];
    return r;
  }
  // s * a + t * b
  friend Partials Combined(double s, const Partials& a, double t, const Partials& b) {
    Partials r;
    for (int i = 0; i < kPairs; ++i) r.pairs_[i] = s * a.pairs_[i] + t * b.pairs_[i];
    return r;
  }
  Partials& operator+=(const Partials& o) {
    for (int i = 0; i < kPairs; ++i) pairs_[i] += o.pairs_[i];
    return *this;
  }
  Partials& operator-=(const Partials& o) {
    for (int i = 0; i < kPairs; ++i) pairs_[i] -= o.pairs_[i];
    return *this;
  }

 private:
  using Pair = double __attribute__((vector_size(16)));
  static constexpr int kPairs = (N + 1) / 2;
  std::array<Pair, kPairs> pairs_{};
};

template <int N>
struct Dual {
  double value = 0;
  Partials<N> partial;

  Dual() = default;
  // A constant. Implicit, so that formulas may mix scalars.
  Dual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
  Dual(double v, const Partials<N>& p) : value(v), partial(p) {}
  // The variable number `index`.
  static Dual Variable(double value, int index) { return {value, Partials<N>::Unit(index)}; }

  Dual& operator+=(const Dual& o) {
    value += o.value;
    partial += o.partial;
    return *this;
  }
  Dual& operator-=(const Dual& o) {
    value -= o.value;
    partial -= o.partial;
    return *this;
  }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator-(const Dual& a) { return a.Chain(-a.value, -1); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, Combined(b.value, a.partial, a.value, b.partial)};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double ratio = a.value / b.value, inverse = 1 / b.value;
    return {ratio, Combined(inverse, a.partial, -ratio * inverse, b.partial)};
  }
  friend Dual operator+(Dual a, double b) { return a.value += b, a; }
  friend Dual operator+(double a, Dual b) { return b.value += a, b; }
  friend Dual operator-(Dual a, double b) { return a.value -= b, a; }
  friend Dual operator-(double a, const Dual& b) { return b.Chain(a - b.value, -1); }
  friend Dual operator*(const Dual& a, double b) { return a.Chain(a.value * b, b); }
  friend Dual operator*(double a, const Dual& b) { return b.Chain(a * b.value, a); }
  friend Dual operator/(const Dual& a, double b) { return a.Chain(a.value / b, 1 / b); }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value);
    return a.Chain(root, 0.5 / root);
  }
  friend Dual sin(const Dual& a) { return a.Chain(std::sin(a.value), std::cos(a.value)); }
  friend Dual cos(const Dual& a) { return a.Chain(std::cos(a.value), -std::sin(a.value)); }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double norm2 = x.value * x.value + y.value * y.value;
    return {std::atan2(y.value, x.value), Combined(x.value / norm2, y.partial, -y.value / norm2, x.partial)};
  }
  friend Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }

 private:
  // f(a) with derivative `slope`.
  Dual Chain(double f, double slope) const { return {f, Scaled(slope, partial)}; }
};

// The value of a scalar, without its derivatives.
inline double ValueOf(double x) { return x; }
template <int N>
double ValueOf(const Dual<N>& x) {
  return x.value;
}

// The values of vectors and frames, without their derivatives.

template <typename T>
Vec2<double> ValueOf(const Vec2<T>& v) {
  return {ValueOf(v.x), ValueOf(v.y)};
}

template <typename T>
Frame<double> ValueOf(const Frame<T>& f) {
  return {ValueOf(f.center), ValueOf(f.right), ValueOf(f.front)};
}

template <typename T, size_t K>
std::array<Frame<double>, K> ValuesOf(const std::array<Frame<T>, K>& frames) {
  std::array<Frame<double>, K> values;
  for (size_t k = 0; k < K; ++k) values[k] = ValueOf(frames[k]);
  return values;
}

// Building blocks of costs whose derivatives stay finite everywhere.

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

}  // namespace flair
