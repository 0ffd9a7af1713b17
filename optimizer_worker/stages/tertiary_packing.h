// SPDX-License-Identifier: GPL-3.0-or-later
// Ends overlaps of things on tops, on walls and under the ceiling that pushing them apart has left.
#pragma once

#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Takes what overlaps out, and what is in its way when that does not help, and searches the exact places
// (exact_places.h) depth first for the cheapest in which nothing overlaps: the least costs first, a bounded number of
// steps. Things stay on their tops; wall pieces may change walls. Where no such places are found nothing moves, but
// flat things (5 cm) may then lie under others. `problem` has the stage's objects placed. Deterministic.
void PackTangles(const SolveInput& input, const StageSpec& stage, Problem& problem, PartialLayout& state);

// Whether these two are in each other's way where they are. Flat things on tops are in nobody's way unless `strict`.
bool InTheWay(const Scene& scene, int a, int b, const Layout& layout, bool strict);

}  // namespace flair::optimizer
