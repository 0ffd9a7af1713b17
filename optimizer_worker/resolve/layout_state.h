// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a layout, for deciding what must move and whether a move has helped.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// What is no business of an edit.
struct Baseline {
  // Per edge of the graph: it held before the edits and has not been edited, so it should hold afterwards.
  std::vector<char> held;
  // Pairs (object, other or -1) that were in each other's way before.
  std::set<std::pair<int, int>> tolerated;
};

struct Grievances {
  // Floor objects that collide, ascending, without pinned ones.
  std::vector<int> colliding;
  // Sum of the depths of their collisions.
  double depth_m = 0;
  // Edges (indices) that held before and do not now.
  std::vector<int> broken;
  // Wall, ceiling and surface objects and rugs that are in the way, without pinned ones.
  std::vector<int> astray;
};

Grievances FindGrievances(const SolveInput& input, const PartialLayout& state, const Baseline& baseline);

// The pairs that are in each other's way in `state`.
std::set<std::pair<int, int>> PairsInTheWay(const SolveInput& input, const PartialLayout& state);

// Cost of the stage's objects, as the stage reckons it; on the floor with the ways through the room and collisions.
double ScoreOf(const SolveInput& input, const StageSpec& stage, const PartialLayout& state);

}  // namespace flair::optimizer
