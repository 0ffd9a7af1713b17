// SPDX-License-Identifier: GPL-3.0-or-later
// Balances the room.
//   cost = | sum a_i p_i / sum a_i - c |^2                                                         [m2]
//   a_i, p_i  footprint area and centre of object i;  c  centre of the room (of its bounding box when a rectangle)
// [Paper] Eq. balanced, as released. Any number of objects: value and gradient are written out.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/cost.h"
#include "room/geometry/vec2.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

class BalancedCost final : public Cost {
 public:
  // `objects` ascending, each once, at least one.
  BalancedCost(const Scene& scene, std::vector<int> objects);

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override;
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override;

 private:
  // Centre of mass minus centre of the room.
  Vec2<double> Offset(std::span<const Frame<double>> frames) const;

  std::vector<int> objects_;
  // a_i / sum a_i.
  std::vector<double> shares_;
  Vec2<double> room_center_;
};

}  // namespace flair::optimizer
