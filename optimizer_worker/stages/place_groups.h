// SPDX-License-Identifier: GPL-3.0-or-later
// Groups as pieces: how the pieces of one can stand together, and where each of them goes.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "optimizer_worker/solver/search.h"
#include "optimizer_worker/stages/groups.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// An edge with its objects as numbers within the group: equal for calls of groups that are alike.
std::string CallText(const SolveInput& input, const Group& group, int edge);

// Stands the group's first piece in an empty room, free or with its back or sides at walls, places the others by the
// calls among them, and keeps what differs; exact, like a polished layout. Empty when they cannot stand without
// overlap.
std::vector<Arrangement> ArrangeGroup(const SolveInput& input, const Group& group);

// Places groups one after the other, each as one piece where that costs least, in the
// arrangement and place that suit all constraints; piece by piece where that costs less. `noise` as in
// LayoutSearch::Construct.
void PlaceGroups(const SolveInput& input, const SearchInput& search_input, std::span<const Group> groups, double noise,
                 Random& random, LayoutSearch& search);

}  // namespace flair::optimizer
