// SPDX-License-Identifier: GPL-3.0-or-later
// How the pieces of a group can stand together, from the calls among them alone.
#pragma once

#include <string>
#include <vector>

#include "optimizer_worker/stages/groups.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// An edge with its objects as numbers within the group: equal for calls of groups that are alike.
std::string CallText(const SolveInput& input, const Group& group, int edge);

// Stands the group's first piece in an empty room, free or with its back or sides at walls, places the others by the
// calls among them, and keeps what differs; exact, like a polished layout. Empty when they cannot stand without overlap.
std::vector<Arrangement> ArrangeGroup(const SolveInput& input, const Group& group);

}  // namespace flair::optimizer
