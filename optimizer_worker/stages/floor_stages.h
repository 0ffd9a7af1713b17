// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of floor objects: furnishing, and the polish of all together with its constrained last step.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// Stages "primary" and "secondary": places new floor objects among those that stand already. Restart 0 places the
// objects in their order, each where it is best; later restarts shuffle the order and add noise. Then sweeps, then
// SLSQP over all of the stage's objects.
RestartResult FurnishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int restart);

// Stage "polish": all floor objects together, ending exactly feasible.

// What a remaining overlap of one metre is worth against any constraint.
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

// The constrained last step: makes a good layout of floor objects exactly feasible, by linear inequalities instead of
// weights.

// Overlaps up to this depth count as touching.
inline constexpr double kTouching_m = 1e-7;

// Headings within this of a wall's direction are made exactly that.
inline constexpr double kSnap_rad = 0.12;

// Turns headings that nearly follow a wall so that they do.
void SnapHeadings(const Scene& scene, std::span<const int> objects, Layout& layout);

// Minimises the problem's cost over the centres of the solid objects among `free`, headings held, so that nothing
// overlaps, everything is inside and out of doors' ways; rugs and other solid objects stay. Returns what still
// collides, deepest first: empty when it all fits.
std::vector<Violation> MakeExact(const SolveInput& input, Problem& problem, std::span<const int> free, Layout& layout);

}  // namespace flair::optimizer
