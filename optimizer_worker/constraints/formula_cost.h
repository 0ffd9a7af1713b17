// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a formula over one, two or three objects into a Cost. A formula is a struct with
//   static constexpr int kObjects;
//   template <typename T> T operator()(const Frames<T, kObjects>& frames) const;   // T: double or Dual<3 * kObjects>
// It gets frames, not poses: headings only ever enter by sine and cosine, so a full turn changes nothing.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "optimizer_worker/autodiff/dual.h"
#include "optimizer_worker/constraints/cost.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

template <typename T, int K>
using Frames = std::array<Frame<T>, K>;

// The frame of one object, with derivatives by variables `first`, `first + 1`, `first + 2` for x, y, theta.
template <int N>
Frame<Dual<N>> DualFrame(const Pose<double>& pose, int first) {
  const double c = std::cos(pose.theta_rad);
  const double s = std::sin(pose.theta_rad);
  Frame<Dual<N>> frame;
  frame.center = {Dual<N>::Variable(pose.x_m, first), Dual<N>::Variable(pose.y_m, first + 1)};
  frame.right = {Dual<N>(c), Dual<N>(s)};
  frame.right.x.partial[static_cast<size_t>(first + 2)] = -s;
  frame.right.y.partial[static_cast<size_t>(first + 2)] = c;
  frame.front = {-frame.right.y, frame.right.x};
  return frame;
}

template <typename Formula>
class FormulaCost final : public Cost {
  static constexpr int kCount = Formula::kObjects;
  static constexpr int kVariables = 3 * kCount;

 public:
  // `objects` in the formula's order, all different.
  FormulaCost(Formula formula, std::array<int, kCount> objects) : formula_(std::move(formula)), sorted_(objects) {
    std::sort(sorted_.begin(), sorted_.end());
    for (int k = 0; k < kCount; ++k) {
      slot_[k] = static_cast<int>(std::find(sorted_.begin(), sorted_.end(), objects[k]) - sorted_.begin());
    }
  }

  std::span<const int> objects() const override { return sorted_; }

  double Value(std::span<const Pose<double>> poses) const override {
    Frames<double, kCount> frames;
    for (int k = 0; k < kCount; ++k) frames[k] = FrameOf(poses[slot_[k]]);
    return formula_(frames);
  }

  double Gradient(std::span<const Pose<double>> poses, std::span<double> gradient) const override {
    // Costs are never negative, so where one is 0 its gradient is 0 too; this is the common case while solving.
    if (Value(poses) == 0) {
      std::fill(gradient.begin(), gradient.end(), 0.0);
      return 0;
    }
    Frames<Dual<kVariables>, kCount> frames;
    for (int k = 0; k < kCount; ++k) frames[k] = DualFrame<kVariables>(poses[slot_[k]], 3 * slot_[k]);
    const Dual<kVariables> cost = formula_(frames);
    std::copy(cost.partial.begin(), cost.partial.end(), gradient.begin());
    return cost.value;
  }

 private:
  Formula formula_;
  std::array<int, kCount> sorted_;
  std::array<int, kCount> slot_;
};

template <typename Formula>
std::unique_ptr<Cost> MakeCost(Formula formula, std::array<int, Formula::kObjects> objects) {
  return std::make_unique<FormulaCost<Formula>>(std::move(formula), objects);
}

}  // namespace flair::optimizer
