// SPDX-License-Identifier: GPL-3.0-or-later
// The constrained last step: makes a good layout of floor objects exactly feasible, by linear inequalities instead of
// weights.
#pragma once

#include <span>
#include <vector>

#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

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
