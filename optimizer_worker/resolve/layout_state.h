// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a layout, for deciding what must move and whether a move has helped.
#pragma once

#include <vector>

#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

struct Grievances {
  // Floor objects of which one collides, pairs as they are; the room and pinned objects are not listed.
  std::vector<int> colliding;
  // Sum of the depths, of all collisions.
  double depth_m = 0;
  // Edges (indices) that held before and do not now.
  std::vector<int> broken;
  // Wall, ceiling, surface objects and rugs that are in the way.
  std::vector<int> astray;

  bool none() const { return colliding.empty() && broken.empty() && astray.empty(); }
};

// `held` says which edges should hold.
Grievances FindGrievances(const SolveInput& input, const PartialLayout& state, const std::vector<char>& held);

// Cost of the stage's objects and of the ways through the room, as the polish reckons it, collisions included.
double FloorScore(const SolveInput& input, const StageSpec& stage, const PartialLayout& state);

}  // namespace flair::optimizer
