// SPDX-License-Identifier: GPL-3.0-or-later
// Poses as messages and back.
#pragma once

#include <vector>

#include "absl/status/status.h"
#include "flair/v1/placement.pb.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// The poses of what is placed, with the heights at which the objects stand or hang.
std::vector<v1::Placement> MakePlacements(const SolveInput& input, const PartialLayout& state);

// Places the objects named. INVALID_ARGUMENT names the entry of `placements` that is wrong.
absl::Status ReadPlacements(const SolveInput& input,
                            const google::protobuf::RepeatedPtrField<v1::Placement>& placements, PartialLayout& state);

// Stages "primary" and "secondary": places new floor objects among those that stand already. Restart 0 places the
// objects in their order, each where it is best; later restarts shuffle the order and add noise. Then sweeps, then
// SLSQP over all of the stage's objects.
RestartResult FurnishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int restart);

}  // namespace flair::optimizer
