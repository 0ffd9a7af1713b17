// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns of groups that are alike: rows, banks that stand back to back, grids, rows along walls.
#pragma once

#include <vector>

#include "optimizer_worker/stages/groups.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Layouts in which the patterns of a stage are placed and the rest is as in `before`, best first: one for a few of its
// restarts each. A pattern without a place where nothing overlaps is left to the groups. Just `before` when there is
// none.
std::vector<PartialLayout> PlacePatterns(const SolveInput& input, const StageSpec& stage, const PartialLayout& before);

// What `state` is charged for groups of patterns that it has placed in no order: about two missed constraints for each.
double DisorderOf(const SolveInput& input, const PartialLayout& state);
// The same for one pattern, all of it placed in `layout`; `groups` are indices in input.groups.all.
double DisorderOf(const SolveInput& input, const std::vector<int>& groups, const Layout& layout);

// The objects that stand in a pattern: their groups are arranged alike, look along the same axes, and each
// is in line with another. They are moved together or not at all.
std::vector<int> InPattern(const SolveInput& input, const PartialLayout& state);

}  // namespace flair::optimizer
