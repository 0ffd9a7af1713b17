// SPDX-License-Identifier: GPL-3.0-or-later
// The whole solve: stages in order, the restarts wherever they are run.
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

struct SolveResult {
  v1::SolvedLayout layout;
  // Wall time per entry of layout.stage_outcomes.
  std::vector<absl::Duration> stage_durations;
};

// Solves a problem. Bit-identical for equal graphs, options and seeds, whatever the number of threads and wherever
// `runner` runs the restarts. INVALID_ARGUMENT when graph or options do not validate; CANCELLED when `cancelled` says
// so; furniture that does not fit is a result with diagnostics. `cancelled` may be null.
absl::StatusOr<SolveResult> SolveLayout(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                        const Solver& solver, const CancelCheck& cancelled = nullptr,
                                        const RestartRunner& runner = LocalRestartRunner());

// Outcomes and metrics of given placements. INVALID_ARGUMENT names the field.
absl::StatusOr<v1::EvaluateResponse> EvaluateLayout(const v1::EvaluateRequest& request, const Solver& solver);

// For a driver elsewhere: restarts [first_restart, first_restart + restart_count) of one stage, exactly as SolveLayout
// runs them. INVALID_ARGUMENT names the field; CANCELLED when `cancelled` says so.
absl::StatusOr<std::vector<v1::RestartOutcome>> SolveStageRestarts(const v1::SolveRestartsRequest& request,
                                                                   const Solver& solver,
                                                                   const CancelCheck& cancelled = nullptr);

}  // namespace flair::optimizer
