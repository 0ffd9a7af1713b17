// SPDX-License-Identifier: GPL-3.0-or-later
// The values of vectors and frames, without their derivatives.
#pragma once

#include <array>

#include "optimizer_worker/autodiff/dual.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

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

}  // namespace flair::optimizer
