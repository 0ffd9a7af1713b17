// SPDX-License-Identifier: GPL-3.0-or-later
// What a layout amounts to: the outcome of every edge and whole-room term, and zone areas.
#pragma once

#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/scene_costs.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// A cost up to this counts as zero: a distance missed by 3 cm, a direction missed by 3 degrees.
inline constexpr double kSatisfiedCost = 1e-3;

// One per edge of the graph, in its order.
std::vector<v1::EdgeOutcome> EdgeOutcomes(const SolveInput& input, const SceneCosts& costs, const PartialLayout& state);

// One per kind of whole-room term, sorted by name, over all placed objects.
std::vector<v1::TermOutcome> TermOutcomes(const SolveInput& input, const SceneCosts& costs, const PartialLayout& state);

// The Voronoi areas of the zones.
std::vector<v1::ZoneRegion> MakeZoneRegions(const SolveInput& input, const PartialLayout& state);

}  // namespace flair::optimizer
