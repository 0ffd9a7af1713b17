// SPDX-License-Identifier: GPL-3.0-or-later
// What formulas over several ways or many objects are made of.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/autodiff/dual.h"
#include "room/geometry/gap.h"

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

// Keeps an object out of areas: the sum of its squared depth in each [m2], which is the shortest push out of it.
inline std::unique_ptr<Cost> ClearOfAreas(int object, const Footprint& footprint, std::vector<ConvexPiece> areas) {
  const auto formula = [footprint, areas = std::move(areas)]<typename T>(const Frames<T, 1>& frames) {
    const Box<T> box(footprint, frames[0]);
    T sum(0.0);
    for (const ConvexPiece& area : areas) sum += SquaredPenetration<T>(box, area);
    return sum;
  };
  return MakeCost<kSeesZero>({object}, formula);
}

// Sums over many objects are differentiated one object at a time: three partials, whatever the number of objects.

// Adds the gradient of `term(frame_i, frame_j)` to `gradient` (three numbers per frame) and returns its value. The term
// depends only on how the two stand to each other.
template <typename Term>
double AddPair(std::span<const Frame<double>> frames, size_t i, size_t j, std::span<double> gradient,
               const Term& term) {
  const Dual<3> value = term(DualFrame<3, 0>(frames[i]), DualFrame<3, 3>(frames[j]));
  for (int k = 0; k < 3; ++k) gradient[3 * i + k] += value.partial[k];
  AddReaction(frames[i], value.partial[0], value.partial[1], value.partial[2], frames[j], gradient.subspan(3 * j, 3));
  return value.value;
}

// The same for a term of one object.
template <typename Term>
double AddSingle(std::span<const Frame<double>> frames, size_t i, std::span<double> gradient, const Term& term) {
  const Dual<3> value = term(DualFrame<3, 0>(frames[i]));
  for (int k = 0; k < 3; ++k) gradient[3 * i + k] += value.partial[k];
  return value.value;
}

}  // namespace flair::optimizer
