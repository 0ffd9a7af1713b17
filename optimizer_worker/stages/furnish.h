// SPDX-License-Identifier: GPL-3.0-or-later
// Stages "primary" and "secondary": places new floor objects among those that stand already.
#pragma once

#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Restart 0 places the objects in their order, each where it is best; later restarts shuffle the order and add noise.
// Then sweeps, then SLSQP over all of the stage's objects.
RestartResult FurnishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int restart);

}  // namespace flair::optimizer
