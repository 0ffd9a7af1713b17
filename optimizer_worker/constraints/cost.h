// SPDX-License-Identifier: GPL-3.0-or-later
// A bound constraint: a differentiable function of the poses of a few objects. It knows their sizes and the room, never
// which variables of a solver they are.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "room/geometry/pose.h"

namespace flair::optimizer {

class Cost {
 public:
  virtual ~Cost() = default;
  // Indices in Scene::objects of the poses it reads, ascending, each once.
  virtual std::span<const int> objects() const = 0;
  // The cost at `poses`, one per entry of objects() in that order. Finite and >= 0 for finite poses; 0 exactly where
  // the sentence holds. Neither function allocates; both are safe to call from several threads.
  virtual double Value(std::span<const Pose<double>> poses) const = 0;
  // Overwrites `gradient`, three numbers (x, y, theta) per object, and returns the value. Always finite.
  virtual double Gradient(std::span<const Pose<double>> poses, std::span<double> gradient) const = 0;
};

}  // namespace flair::optimizer
