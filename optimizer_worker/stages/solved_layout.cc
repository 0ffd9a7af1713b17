// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solved_layout.h"

#include "evaluation/metrics/layout_metrics.h"
#include "optimizer_worker/stages/outcomes.h"
#include "optimizer_worker/stages/placements.h"

namespace flair::optimizer {

v1::SolvedLayout MakeSolvedLayout(const SolveInput& input, const std::vector<Branch>& branches) {
  const Branch& best = branches.front();
  v1::SolvedLayout layout;
  *layout.mutable_graph() = input.graph;
  const SceneCosts costs = BindCosts(input, ZoneCenters(input.scene, best.state.placed, best.state.layout));
  for (v1::Placement& placement : MakePlacements(input, best.state)) *layout.add_placements() = std::move(placement);
  for (v1::ZoneRegion& region : MakeZoneRegions(input, best.state)) *layout.add_zone_regions() = std::move(region);
  double total = 0;
  for (v1::EdgeOutcome& outcome : EdgeOutcomes(input, costs, best.state)) {
    total += outcome.weighted_cost();
    *layout.add_edge_outcomes() = std::move(outcome);
  }
  for (v1::TermOutcome& outcome : TermOutcomes(input, costs, best.state)) {
    total += outcome.cost() * outcome.factor();
    *layout.add_term_outcomes() = std::move(outcome);
  }
  for (const v1::StageOutcome& outcome : best.outcomes) *layout.add_stage_outcomes() = outcome;
  for (size_t i = 1; i < branches.size(); ++i) {
    v1::RunnerUp* runner_up = layout.add_runner_ups();
    runner_up->set_cost(branches[i].score);
    for (v1::Placement& placement : MakePlacements(input, branches[i].state)) {
      *runner_up->add_placements() = std::move(placement);
    }
  }
  for (v1::Diagnostic& diagnostic : FitDiagnostics(input, best.state))
    *layout.add_diagnostics() = std::move(diagnostic);
  layout.set_total_cost(total);
  *layout.mutable_metrics() = evaluation::MeasureLayout({input.scene, best.state.layout, best.state.placed});
  return layout;
}

}  // namespace flair::optimizer
