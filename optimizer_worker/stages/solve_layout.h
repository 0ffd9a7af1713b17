// SPDX-License-Identifier: GPL-3.0-or-later
// The whole solve: stages in order, each on RunRestarts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// Called as a stage ends, with its name and what it reached; from the calling thread.
using Progress = std::function<void(const std::string& stage, const std::string& message)>;

struct SolveResult {
  v1::SolvedLayout layout;
  // Wall time per entry of layout.stage_outcomes.
  std::vector<absl::Duration> stage_durations;
};

// Solves a problem. Bit-identical for equal graphs, options and seeds, whatever the number of threads. INVALID_ARGUMENT
// when graph or options do not validate; CANCELLED when `cancelled` says so; furniture that does not fit is a result
// with diagnostics. `progress` and `cancelled` may be null.
absl::StatusOr<SolveResult> SolveLayout(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                        const Solver& solver, const CancelCheck& cancelled = nullptr,
                                        const Progress& progress = nullptr);

// Restarts [first_restart, first_restart + restart_count) of one stage, exactly as SolveLayout runs them.
absl::StatusOr<std::vector<v1::RestartOutcome>> SolveStageRestarts(const v1::SolveRestartsRequest& request,
                                                                   const Solver& solver,
                                                                   const CancelCheck& cancelled = nullptr);

// Outcomes of given placements.
absl::StatusOr<v1::EvaluateResponse> EvaluateLayout(const v1::EvaluateRequest& request, const Solver& solver);

}  // namespace flair::optimizer
