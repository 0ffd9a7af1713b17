// SPDX-License-Identifier: GPL-3.0-or-later
// The least of several ways in which a sentence can hold.
#pragma once

#include <limits>
#include <type_traits>

#include "optimizer_worker/autodiff/frame_value.h"
#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

// min over `ways` of way_cost(way, frames). Finds the least on the values and differentiates that one only, unless it
// is 0; ties go to the first. 0 when there are no ways.
template <typename T, typename Ways, size_t K, typename WayCost>
T LeastOf(const Ways& ways, const std::array<Frame<T>, K>& frames, const WayCost& way_cost) {
  const std::array<Frame<double>, K> values = ValuesOf(frames);
  double least = std::numeric_limits<double>::infinity();
  size_t best = 0;
  for (size_t i = 0; i < std::size(ways); ++i) {
    const double cost = way_cost(ways[i], values);
    if (cost < least) least = cost, best = i;
  }
  if (std::size(ways) == 0) return T(0.0);
  if constexpr (std::is_same_v<T, double>) {
    return least;
  } else {
    return least == 0 ? T(0.0) : way_cost(ways[best], frames);
  }
}

}  // namespace flair::optimizer
