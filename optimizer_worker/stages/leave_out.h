// SPDX-License-Identifier: GPL-3.0-or-later
// Misfits left out: what cannot stand in a room with the rest does not have to.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Takes the fewest and least important objects out of a layout so that nothing is in anything's way any more:
// tertiaries first, then secondaries, then those that the brief asked for, primaries last, pinned ones never; what is
// carried by one that goes, goes with it. Notes each with its reason.
void LeaveOutOf(const SolveInput& input, Branch& branch);

// The same for the best of `branches`, then solves the rest anew and puts back, most important first, what fits after
// all: sometimes everything. Other complete branches lose what does not fit in them. Nothing stays out for something
// less important that fits only without it. Returns `branches` when everything fits. Errors as Driver::Run.
absl::StatusOr<std::vector<Branch>> SolveWithoutMisfits(const SolveInput& input, const RestartRunner& runner,
                                                        std::vector<Branch> branches);

using IdSet = std::set<std::string, std::less<>>;

// Takes objects out of a graph with all that refers to them: edges that name them (one that lists several objects only
// loses the name), pins, hosts, sentences' subjects and styles. Returns a diagnostic per edge changed or taken out.
std::vector<v1::Diagnostic> RemoveObjects(const IdSet& ids, v1::LayoutGraph& graph);

}  // namespace flair::optimizer
