// SPDX-License-Identifier: GPL-3.0-or-later
// A vector or point in the plane, metres, templated on the scalar so that one formula serves values and derivatives.
#pragma once

#include <cmath>

namespace flair {

template <typename T>
struct Vec2 {
  T x{};
  T y{};

  Vec2& operator+=(const Vec2& o) {
    x += o.x;
    y += o.y;
    return *this;
  }
  friend Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
  friend Vec2 operator*(const T& s, const Vec2& a) { return {s * a.x, s * a.y}; }
  friend Vec2 operator*(const Vec2& a, const T& s) { return {a.x * s, a.y * s}; }
  friend bool operator==(const Vec2& a, const Vec2& b) { return a.x == b.x && a.y == b.y; }
};

template <typename T>
T Dot(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.x + a.y * b.y;
}

// z of the cross product: positive when b is counter-clockwise of a.
template <typename T>
T Cross(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.y - a.y * b.x;
}

template <typename T>
T SquaredNorm(const Vec2<T>& a) {
  return a.x * a.x + a.y * a.y;
}

inline double Norm(const Vec2<double>& a) { return std::hypot(a.x, a.y); }
inline double Distance(const Vec2<double>& a, const Vec2<double>& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// A quarter turn counter-clockwise.
template <typename T>
Vec2<T> Perpendicular(const Vec2<T>& a) {
  return {-a.y, a.x};
}

// The same point with another scalar.
template <typename To, typename From>
Vec2<To> Cast(const Vec2<From>& a) {
  return {To(a.x), To(a.y)};
}

}  // namespace flair
