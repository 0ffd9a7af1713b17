// SPDX-License-Identifier: GPL-3.0-or-later
// The account of a solve as a message.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// The first of `branches` (not empty) as the layout, the others as runners-up: complete ones in full, others with their
// placements only.
v1::SolvedLayout MakeSolvedLayout(const SolveInput& input, const std::vector<Branch>& branches);

// What the settings ended early or could not have, as diagnostics: the time limit, fewer variants than asked for.
std::vector<v1::Diagnostic> SolveDiagnostics(const SolveInput& input, const std::vector<Branch>& branches);

// When two layouts of a problem differ so much that a person sees two.

// The objects that make the difference: the primaries that may move; all floor objects that may move when no primary
// may. Tertiaries make none.
std::vector<int> LeadingObjects(const SolveInput& input);

// Whether one of `objects` stands more than 0.5 m away or is turned by more than 30 degrees. Symmetric copies differ.
bool DifferVisibly(std::span<const int> objects, const Layout& a, const Layout& b);

// Of `count` things, up to `most` that are all different from each other; those of least score come first and are
// preferred, equal scores by number.
std::vector<size_t> BestDistinct(size_t count, size_t most, const std::function<double(size_t)>& score,
                                 const std::function<bool(size_t, size_t)>& differ);

}  // namespace flair::optimizer
