// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps an object's centre in the Voronoi cell of a zone: cost as in measure/outside.h [m2]. Zero exactly in the cell.
// The released ind_in_region is 5 times this.
#pragma once

#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/vec2.h"

namespace flair::optimizer {

struct InZone {
  static constexpr int kObjects = 1;
  std::vector<Vec2<double>> centers;
  int zone;

  template <typename T>
  T operator()(const Frames<T, 1>& frames) const;
};

}  // namespace flair::optimizer
