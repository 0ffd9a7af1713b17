// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of a layout though no call asks for it, and is lost by an edit without a word: that a shelf stands against
// its wall, that one gets to the floor and to the fronts from the door.
#pragma once

#include <vector>

#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/provenance.pb.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Adds a call against_wall of weight 1 for each solid object that stands flush on a wall in `before`, is not pinned and
// not among `touched` (ascending): a search then keeps it there unless that costs more.
void HoldWalls(const SolveInput& input, const PartialLayout& before, const std::vector<int>& touched,
               v1::LayoutGraph& graph);

// What an edit has spoiled for objects that it is not about: off_wall (it stands at no wall any more), way_blocked
// (less of the floor can be reached from the door), front_blocked (nobody gets to its front). Names what is in the way.
std::vector<v1::Diagnostic> LossesOf(const SolveInput& input, const PartialLayout& before, const PartialLayout& after,
                                     const std::vector<int>& touched);

}  // namespace flair::optimizer
