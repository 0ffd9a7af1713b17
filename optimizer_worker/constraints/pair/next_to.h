// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a side of one object next to a side of another.
//   cost = min over allowed pairs of sides of  gap^2 + overhang^2 + (1 + n1 . n2)                  [m2]
//   gap       distance of the object's side's middle along the target side's outward normal, beyond [0, kSlack]
//   overhang  how far the shorter side sticks out beyond the longer, max(|along| - |L1 - L2| / 2, 0)
//   n1, n2    outward normals of the two sides; opposed when the sides meet
// Zero exactly when the sides meet (up to 5 cm of air), parallel, the shorter within the longer. Sides left out may be
// any. The released io_next_to mixes metres and fractions and is right only for sides of 1 m (SEMANTICS.md section 4).
#pragma once

#include <utility>
#include <vector>

#include "optimizer_worker/constraints/formula_cost.h"
#include "room/geometry/footprint.h"

namespace flair::optimizer {

// Air that still counts as next to.
inline constexpr double kNextToSlack_m = 0.05;

// The cost of one pair of sides, shared with groups.
template <typename T>
T SidesMeet(const Footprint& first, const Frame<T>& first_frame, Side first_side, const Footprint& second,
            const Frame<T>& second_frame, Side second_side);

struct NextTo {
  static constexpr int kObjects = 2;
  static constexpr bool kOnlyRelative = true;
  static constexpr bool kSeesZero = true;
  Footprint object;
  Footprint target;
  // Side of the object, side of the target.
  std::vector<std::pair<Side, Side>> ways;

  template <typename T>
  T operator()(const Frames<T, 2>& frames) const;
};

}  // namespace flair::optimizer
