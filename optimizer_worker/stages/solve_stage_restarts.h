// SPDX-License-Identifier: GPL-3.0-or-later
// The restarts of one stage, for a driver elsewhere.
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// Restarts [first_restart, first_restart + restart_count) of one stage, exactly as SolveLayout runs them.
// INVALID_ARGUMENT names the field; CANCELLED when `cancelled` says so.
absl::StatusOr<std::vector<v1::RestartOutcome>> SolveStageRestarts(const v1::SolveRestartsRequest& request,
                                                                   const Solver& solver,
                                                                   const CancelCheck& cancelled = nullptr);

}  // namespace flair::optimizer
