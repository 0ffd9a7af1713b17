// SPDX-License-Identifier: GPL-3.0-or-later
// Forward-mode automatic differentiation: a value with its partial derivatives with respect to N variables. A formula
// templated on its scalar gives the value with double and value and gradient with Dual<N>; both take the same branches,
// because comparisons look at the value only.
#pragma once

#include <array>
#include <cmath>

namespace flair::optimizer {

template <int N>
struct Dual {
  double value = 0;
  std::array<double, N> partial{};

  Dual() = default;
  // A constant. Implicit, so that formulas may mix scalars.
  Dual(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
  // The variable number `index`.
  static Dual Variable(double value, int index) {
    Dual d(value);
    d.partial[static_cast<size_t>(index)] = 1;
    return d;
  }

  Dual& operator+=(const Dual& o) {
    value += o.value;
    for (int i = 0; i < N; ++i) partial[i] += o.partial[i];
    return *this;
  }
  Dual& operator-=(const Dual& o) {
    value -= o.value;
    for (int i = 0; i < N; ++i) partial[i] -= o.partial[i];
    return *this;
  }
  friend Dual operator+(Dual a, const Dual& b) { return a += b; }
  friend Dual operator-(Dual a, const Dual& b) { return a -= b; }
  friend Dual operator-(const Dual& a) { return a.Chain(-a.value, -1); }
  friend Dual operator*(const Dual& a, const Dual& b) {
    Dual r(a.value * b.value);
    for (int i = 0; i < N; ++i) r.partial[i] = a.partial[i] * b.value + a.value * b.partial[i];
    return r;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    Dual r(a.value / b.value);
    for (int i = 0; i < N; ++i) r.partial[i] = (a.partial[i] - r.value * b.partial[i]) / b.value;
    return r;
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
    Dual r(std::atan2(y.value, x.value));
    for (int i = 0; i < N; ++i) r.partial[i] = (x.value * y.partial[i] - y.value * x.partial[i]) / norm2;
    return r;
  }
  friend Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }

 private:
  // f(a) with derivative `slope`.
  Dual Chain(double f, double slope) const {
    Dual r(f);
    for (int i = 0; i < N; ++i) r.partial[i] = slope * partial[i];
    return r;
  }
};

// The value of a scalar, without its derivatives.
inline double ValueOf(double x) { return x; }
template <int N>
double ValueOf(const Dual<N>& x) {
  return x.value;
}

}  // namespace flair::optimizer
