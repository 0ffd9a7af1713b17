// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/evaluate_layout.h"

#include "evaluation/metrics/layout_metrics.h"
#include "optimizer_worker/stages/outcomes.h"
#include "optimizer_worker/stages/placements.h"

namespace flair::optimizer {

absl::StatusOr<v1::EvaluateResponse> EvaluateLayout(const v1::EvaluateRequest& request, const Solver& solver) {
  absl::StatusOr<SolveInput> input = MakeSolveInput(request.layout_graph(), request.options(), solver, nullptr);
  if (!input.ok()) return input.status();
  PartialLayout state(input->scene);
  if (absl::Status status = ReadPlacements(*input, request.placements(), state); !status.ok()) return status;
  const SceneCosts costs = BindCosts(*input, ZoneCenters(input->scene, state.placed, state.layout));
  v1::EvaluateResponse response;
  for (v1::EdgeOutcome& outcome : EdgeOutcomes(*input, costs, state))
    *response.add_edge_outcomes() = std::move(outcome);
  for (v1::TermOutcome& outcome : TermOutcomes(*input, costs, state))
    *response.add_term_outcomes() = std::move(outcome);
  *response.mutable_metrics() = evaluation::MeasureLayout({input->scene, state.layout, state.placed});
  return response;
}

}  // namespace flair::optimizer
