// SPDX-License-Identifier: GPL-3.0-or-later
// What goes along when an object moves.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// The pose of a rider that keeps its place relative to its carrier.
Pose<double> Carried(const Pose<double>& carrier_before, const Pose<double>& carrier_after, const Pose<double>& rider);

// Things that stood on one of `movers` in `before` keep their place on it in `after`, and so does what stands on them.
// Pinned things and those that are movers themselves do not follow.
void Follow(const SolveInput& input, const PartialLayout& before, std::span<const int> movers, PartialLayout& after);

// Puts a surface object whose carrier is gone on another piece of furniture that has room for it: the nearest of the
// name or category of what it stood on, else the nearest of a like kind: cushions go from seat to seat, books do not.
// Takes it out of the layout when there is none. `lost` is what it stood on, null when not known.
void PutOnLikeTop(const SolveInput& input, int object, const Object* lost, PartialLayout& state);

// Objects that an edge names, ascending.
std::vector<int> ObjectsOfEdge(const SolveInput& input, int edge);

}  // namespace flair::optimizer
