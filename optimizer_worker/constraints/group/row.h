// SPDX-License-Identifier: GPL-3.0-or-later
// Stands objects side by side.
//   cost = sum over neighbours (a left of b) of  out(gap, [0, 0.05])^2 + offset^2 + (1 - cos(theta_a - theta_b)) [m2]
//   gap     air between the right side of a and the left side of b;  offset  of b's back from the line of a's back
// Neighbours are next to each other in order along the first object's right, wherever they stand in the list. Zero
// exactly when they form one row with flush backs and the same heading.
#pragma once

#include <array>
#include <vector>

#include "optimizer_worker/constraints/cost.h"
#include "room/scene/scene.h"

namespace flair::optimizer {

class RowCost final : public Cost {
 public:
  static constexpr int kMaxObjects = 16;

  // Two to kMaxObjects objects.
  RowCost(const Scene& scene, const std::vector<int>& objects);

  std::span<const int> objects() const override { return objects_; }
  double ValueAt(std::span<const Frame<double>> frames) const override;
  double GradientAt(std::span<const Frame<double>> frames, std::span<double> gradient) const override;

 private:
  // Positions in objects_, from left to right.
  std::array<size_t, kMaxObjects> Order(std::span<const Frame<double>> frames) const;
  template <typename T>
  T NeighbourCost(const Footprint& left, const Frame<T>& left_frame, const Footprint& right,
                  const Frame<T>& right_frame) const;

  std::vector<int> objects_;
  std::vector<Footprint> footprints_;
};

}  // namespace flair::optimizer
