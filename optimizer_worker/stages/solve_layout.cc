// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_layout.h"

#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/leave_out.h"
#include "optimizer_worker/stages/solved_layout.h"

namespace flair::optimizer {

absl::StatusOr<SolveResult> SolveLayout(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                        const Solver& solver, const CancelCheck& cancelled,
                                        const RestartRunner& runner) {
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, options, solver, cancelled);
  if (!input.ok()) return input.status();
  absl::StatusOr<std::vector<Branch>> branches = Driver(*input, runner).Run();
  if (!branches.ok()) return branches.status();
  absl::StatusOr<std::vector<Branch>> fitting = SolveWithoutMisfits(*input, runner, *branches);
  if (!fitting.ok()) return fitting.status();
  if (input->Cancelled()) return absl::CancelledError("cancelled when all was placed");
  // Placing the misfits last may find room for all of them; when it does not, the policy decides.
  if (input->settings.leave_out_misfits) {
    branches = std::move(fitting);
  } else if (fitting->front().left_out.empty()) {
    branches->front() = std::move(fitting->front());
  }
  return SolveResult{MakeSolvedLayout(*input, *branches), branches->front().durations};
}

}  // namespace flair::optimizer
