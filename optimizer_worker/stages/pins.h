// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that the user has pinned: they stand from the start, count in every cost, and no stage moves them.
#pragma once

#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// The layout before the first stage: the pinned objects only.
PartialLayout StartOf(const SolveInput& input);

// MakeStage without the pinned objects.
StageSpec FreeStage(const SolveInput& input, StageKind kind, int zone = -1);

}  // namespace flair::optimizer
