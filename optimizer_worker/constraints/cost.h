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

}  // namespace flair::optimizer
