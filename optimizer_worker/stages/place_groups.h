// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "optimizer_worker/solver/search.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// Places groups one after the other, each as one piece where that costs least, in the
// arrangement and place that suit all constraints; piece by piece where that costs less. `noise` as in
// LayoutSearch::Construct.
void PlaceGroups(const SolveInput& input, const SearchInput& search_input, std::span<const Group> groups, double noise,
                 Random& random, LayoutSearch& search);

}  // namespace flair::optimizer
