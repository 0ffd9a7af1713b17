// SPDX-License-Identifier: GPL-3.0-or-later
// The account of a solve as a message.
#pragma once

#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// The first of `branches` (not empty) as the layout, the others as runners-up: complete ones in full, others with their
// placements only.
v1::SolvedLayout MakeSolvedLayout(const SolveInput& input, const std::vector<Branch>& branches);

// What the settings ended early or could not have, as diagnostics: the time limit, fewer variants than asked for.
std::vector<v1::Diagnostic> SolveDiagnostics(const SolveInput& input, const std::vector<Branch>& branches);

}  // namespace flair::optimizer
