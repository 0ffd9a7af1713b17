// SPDX-License-Identifier: GPL-3.0-or-later
// Turns a formula over one, two or three objects into a Cost. A formula is
//   [...]<typename T>(const Frames<T, K>& frames) -> T { ... }   // K objects; T: double or a Dual
// It gets frames, not poses: headings only ever enter by sine and cosine, so a full turn changes nothing.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "room/autodiff/dual.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

// A bound constraint: a differentiable function of the poses of a few objects. It knows their sizes and the room, never
// which variables of a solver they are.

class Cost {
 public:
  virtual ~Cost() = default;
  // Indices in Scene::objects of the poses it reads, ascending, each once.
  virtual std::span<const int> objects() const = 0;
  // The cost at `frames`, one per entry of objects() in that order. Finite and >= 0 for finite frames; 0 exactly where
  // the sentence holds. None of these functions allocates; all are safe to call from several threads.
  virtual double ValueAt(std::span<const Frame<double>> frames) const = 0;
  // Overwrites `gradient`, three numbers (x, y, theta) per object, and returns the value. Always finite.
  virtual double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const = 0;

  // For a search that moves one object, the one at `moving` in objects(), and tries many poses of it: the part of the
  // value that does not depend on that pose, and the value that has this part given. Worth overriding for sums over
  // many objects.
  virtual double FixedPart(std::span<const Frame<double>>, size_t /*moving*/) const { return 0; }
  virtual double ValueGiven(double /*fixed_part*/, std::span<const Frame<double>> frames, size_t /*moving*/) const {
    return ValueAt(frames);
  }

  // The same from poses, for one evaluation; allocates.
  double Value(std::span<const Pose<double>> poses) const { return ValueAt(FramesOf(poses)); }
  double Gradient(std::span<const Pose<double>> poses, std::span<double> gradient) const {
    return GradientAt(FramesOf(poses), gradient);
  }

 private:
  static std::vector<Frame<double>> FramesOf(std::span<const Pose<double>> poses) {
    std::vector<Frame<double>> frames;
    for (const Pose<double>& pose : poses) frames.push_back(FrameOf(pose));
    return frames;
  }
};

template <typename T, int K>
using Frames = std::array<Frame<T>, K>;

// The frame of one object, with derivatives by variables kFirst, kFirst + 1, kFirst + 2 for x, y, theta; a constant
// when there are no such variables.
template <int N, int kFirst>
Frame<Dual<N>> DualFrame(const Frame<double>& value) {
  const double c = value.right.x;
  const double s = value.right.y;
  const auto turning = [](double v, double slope) { return Dual<N>(v, Partials<N>::At(kFirst + 2, slope)); };
  return {{Dual<N>::Variable(value.center.x, kFirst), Dual<N>::Variable(value.center.y, kFirst + 1)},
          {turning(c, -s), turning(s, c)},
          {turning(-s, -c), turning(c, -s)}};
}

// A cost that depends only on how its objects stand to each other does not change when all move together, so that the
// derivatives by one pose follow from those by the others. What `moved`, with derivatives `gx, gy, gtheta` by its pose,
// contributes to the derivatives by the pose of `fixed`:
//   shift: sum over objects of (gx, gy) = 0;  turn about `fixed`: sum of gtheta + (p - p_fixed) x (gx, gy) = 0
inline void AddReaction(const Frame<double>& moved, double gx, double gy, double gtheta, const Frame<double>& fixed,
                        std::span<double> gradient) {
  gradient[0] -= gx;
  gradient[1] -= gy;
  gradient[2] -= gtheta + Cross(moved.center - fixed.center, Vec2<double>{gx, gy});
}

// What else holds of a formula, which makes it faster.
enum FormulaTraits : unsigned {
  kOnlyRelative = 1,  // the room does not enter: T has three derivatives fewer
  kSeesZero = 2,      // finds out on values that it is 0, before any derivative
};

template <typename Formula>
constexpr int ObjectCount() {
  if constexpr (std::is_invocable_v<const Formula&, Frames<double, 1>>) return 1;
  if constexpr (std::is_invocable_v<const Formula&, Frames<double, 2>>) return 2;
  return 3;
}

template <typename Formula, unsigned traits>
class FormulaCost final : public Cost {
  static constexpr int kCount = ObjectCount<Formula>();
  // Of the formula's objects the first so many have derivatives.
  static constexpr int kMoving = (traits & kOnlyRelative) != 0 ? kCount - 1 : kCount;
  static constexpr int kVariables = 3 * kMoving;

 public:
  // `objects` in the formula's order, all different.
  FormulaCost(Formula formula, std::array<int, kCount> objects) : formula_(std::move(formula)), sorted_(objects) {
    std::ranges::sort(sorted_);
    for (int k = 0; k < kCount; ++k) {
      slot_[k] = static_cast<int>(std::ranges::find(sorted_, objects[k]) - sorted_.begin());
    }
  }

  std::span<const int> objects() const override { return sorted_; }

  double ValueAt(std::span<const Frame<double>> frames) const override {
    Frames<double, kCount> operands;
    for (int k = 0; k < kCount; ++k) operands[k] = frames[slot_[k]];
    return formula_(operands);
  }

  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override {
    // Costs are never negative, so where one is 0 its gradient is 0 too; this is the common case while solving.
    if ((traits & kSeesZero) == 0 && ValueAt(frames) == 0) {
      std::ranges::fill(gradient, 0.0);
      return 0;
    }
    const Dual<kVariables> cost = formula_(DualFrames(frames, std::make_integer_sequence<int, kCount>()));
    for (int k = 0; k < kMoving; ++k) {
      for (int c = 0; c < 3; ++c) gradient[3 * slot_[k] + c] = cost.partial[3 * k + c];
    }
    if constexpr ((traits & kOnlyRelative) != 0) {
      const int last = slot_[kCount - 1];
      const std::span<double> reaction = gradient.subspan(3 * last, 3);
      std::ranges::fill(reaction, 0.0);
      for (int k = 0; k < kMoving; ++k) {
        AddReaction(frames[slot_[k]], cost.partial[3 * k], cost.partial[3 * k + 1], cost.partial[3 * k + 2],
                    frames[last], reaction);
      }
    }
    return cost.value;
  }

 private:
  template <int... k>
  Frames<Dual<kVariables>, kCount> DualFrames(std::span<const Frame<double>> frames,
                                              std::integer_sequence<int, k...>) const {
    return {DualFrame<kVariables, 3 * k>(frames[slot_[k]])...};
  }

  Formula formula_;
  std::array<int, kCount> sorted_;
  std::array<int, kCount> slot_;
};

// Of `objects` in the formula's order, all different.
template <unsigned traits = 0, typename Formula>
std::unique_ptr<Cost> MakeCost(std::array<int, ObjectCount<Formula>()> objects, Formula formula) {
  return std::make_unique<FormulaCost<Formula, traits>>(std::move(formula), objects);
}

}  // namespace flair::optimizer
