// SPDX-License-Identifier: GPL-3.0-or-later
// Angles, and where an object is: frame O in the room frame R. O has its origin in the object's centre, x to its right
// and y to its front, as seen by somebody standing behind it and looking the way it faces. Angles are radians,
// counter-clockwise; heading 0 faces +y (north).
#pragma once

#include <cmath>
#include <numbers>

namespace flair {

// A vector or point in the plane, metres, templated on the scalar so that one formula serves values and derivatives.

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

template <typename T>
struct Pose {
  T x_m{};
  T y_m{};
  // Counter-clockwise; 0 faces +y.
  T theta_rad{};

  friend bool operator==(const Pose& a, const Pose& b) {
    return a.x_m == b.x_m && a.y_m == b.y_m && a.theta_rad == b.theta_rad;
  }
};

// A pose with the sine and cosine of its heading worked out once.
template <typename T>
struct Frame {
  Vec2<T> center;
  // Unit vector to the right of the object, (cos, sin).
  Vec2<T> right;
  // Unit vector to its front, (-sin, cos).
  Vec2<T> front;

  // p_R = X_RO p_O: a point given in the object's frame, in room frame.
  Vec2<T> ToRoom(const T& right_m, const T& front_m) const {
    return {center.x + right_m * right.x + front_m * front.x, center.y + right_m * right.y + front_m * front.y};
  }
  // p_O: a point given in room frame, in the object's frame.
  Vec2<T> ToObject(const Vec2<T>& p) const {
    const Vec2<T> d = p - center;
    return {Dot(d, right), Dot(d, front)};
  }
};

template <typename T>
Frame<T> FrameOf(const Pose<T>& pose) {
  using std::cos;
  using std::sin;
  const T c = cos(pose.theta_rad);
  const T s = sin(pose.theta_rad);
  return {{pose.x_m, pose.y_m}, {c, s}, {-s, c}};
}

// Whose look it is where an object faces something: its own, out of its front, or that of whoever uses it from its
// front and looks over it, as at a desk.
enum class Look { kOwn, kOfUser };

// With the look ahead.
template <typename T>
Frame<T> LookOf(const Frame<T>& frame, Look look) {
  return look == Look::kOwn ? frame : Frame<T>{frame.center, -frame.right, -frame.front};
}

template <typename T>
Vec2<T> Center(const Pose<T>& pose) {
  return {pose.x_m, pose.y_m};
}

// Unit vector to the front.
template <typename T>
Vec2<T> Front(const Pose<T>& pose) {
  return FrameOf(pose).front;
}

}  // namespace flair
