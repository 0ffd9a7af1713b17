// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over many objects, differentiated one object at a time: three partials, whatever the number of objects.
#pragma once

#include <span>

#include "optimizer_worker/constraints/formula_cost.h"

namespace flair::optimizer {

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
