// SPDX-License-Identifier: GPL-3.0-or-later
// A solve as messages: poses, the outcome of every constraint, and the account of it all.
#pragma once

#include <vector>

#include "absl/status/status.h"
#include "flair/v1/placement.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Poses as messages and back.

// The poses of what is placed, with the heights at which the objects stand or hang.
std::vector<v1::Placement> MakePlacements(const SolveInput& input, const PartialLayout& state);

// Places the objects named. INVALID_ARGUMENT names the entry of `placements` that is wrong.
absl::Status ReadPlacements(const SolveInput& input,
                            const google::protobuf::RepeatedPtrField<v1::Placement>& placements, PartialLayout& state);

// What a layout amounts to: the outcome of every edge and whole-room term, and zone areas.

// A cost up to this counts as zero: a distance missed by 3 cm, a direction missed by 3 degrees.
inline constexpr double kSatisfiedCost = 1e-3;

// One per edge of the graph, in its order.
std::vector<v1::EdgeOutcome> EdgeOutcomes(const SolveInput& input, const SceneCosts& costs, const PartialLayout& state);

// One per kind of whole-room term, sorted by name, over all placed objects.
std::vector<v1::TermOutcome> TermOutcomes(const SolveInput& input, const SceneCosts& costs, const PartialLayout& state);

// The Voronoi areas of the zones.
std::vector<v1::ZoneRegion> MakeZoneRegions(const SolveInput& input, const PartialLayout& state);

// The first of `branches` (not empty) as the layout, the others as runners-up: complete ones in full, others with their
// placements only.
v1::SolvedLayout MakeSolvedLayout(const SolveInput& input, const std::vector<Branch>& branches);

// What the settings ended early or could not have, as diagnostics: the time limit, fewer variants than asked for.
std::vector<v1::Diagnostic> SolveDiagnostics(const SolveInput& input, const std::vector<Branch>& branches);

}  // namespace flair::optimizer
