// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// As PolishRestart over all floor objects that may move, but `held` ones move only as far as the exact step has to push
// them: the polish of a variant that would otherwise become the same layout as another.
RestartResult PolishHolding(const SolveInput& input, const PartialLayout& before, std::span<const int> held,
                            int restart);

}  // namespace flair::optimizer
