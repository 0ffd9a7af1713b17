// SPDX-License-Identifier: GPL-3.0-or-later
// Constraints that cannot hold together: why a violated one is violated.
#pragma once

#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// For each violated edge of `layout` (the result for input.graph) a minimal group of edges that cannot hold together,
// by deletion: the edge and the satisfied edges on its objects are solved for these objects alone, in the room with its
// pins; while they cannot hold, edges are left out one by one, and those without which they still cannot stay out. A
// group of one cannot hold in this room at all. No group is found where other furniture is in the way, where only more
// distant edges clash, or for edges about zones, which depend on everything.
//
// "Cannot hold" is what a bounded search finds: kHoldRestarts starts per stage, as deterministic as a solve. At most
// kMostTrials searches in all; violated edges are taken in the graph's order. Stops early when cancelled or out of
// time.
std::vector<v1::Contradiction> FindContradictions(const SolveInput& input, const v1::SolvedLayout& layout);

inline constexpr int kHoldRestarts = 4;
inline constexpr int kMostTrials = 150;

}  // namespace flair::optimizer
