// SPDX-License-Identifier: GPL-3.0-or-later
// Stage "polish": all floor objects together, ending exactly feasible.
#pragma once

#include <span>

#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// What a remaining overlap of one metre is worth against any wish.
inline constexpr double kInfeasible = 100;

// How often a polish goes over everything before it makes the layout exact.
inline constexpr int kPolishPasses = 2;

// Starts from `before`, in which every object of the stage is placed. Moves pieces together with what belongs to them,
// takes out neighbours and places them anew, keeps what lowers cost and improves the ways through the room; then SLSQP
// over everything and the constrained last step. Runs before the tertiaries are placed, so that those see the final
// floor (the paper places them first; they do not act on the floor).
RestartResult PolishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int restart,
                            int passes = kPolishPasses);

// As PolishRestart over all floor objects that may move, but `held` ones move only as far as the exact step has to push
// them: the polish of a variant that would otherwise become the same layout as another.
RestartResult PolishHolding(const SolveInput& input, const PartialLayout& before, std::span<const int> held,
                            int restart);

}  // namespace flair::optimizer
