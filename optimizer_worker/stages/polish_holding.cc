// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/polish_holding.h"

#include <algorithm>

#include "optimizer_worker/stages/exact_step.h"
#include "optimizer_worker/stages/pins.h"
#include "optimizer_worker/stages/polish.h"

namespace flair::optimizer {

RestartResult PolishHolding(const SolveInput& input, const PartialLayout& before, std::span<const int> held,
                            int restart) {
  const StageSpec whole = FreeStage(input, StageKind::kPolish);
  StageSpec rest = whole;
  std::erase_if(rest.objects, [&](int o) { return std::find(held.begin(), held.end(), o) != held.end(); });
  RestartResult result = PolishRestart(input, rest, before, restart);
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, result.state.placed, result.state.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input{input.scene,    input.partners,        centers, input.solver,
                                 input.keep_out, &input.fine_walk_grid, {},      input.Over()};
  LayoutSearch search(search_input, MakeProblem(input, costs, whole, result.state), result.state.layout);
  Layout layout = search.layout();
  const std::vector<Violation> left = MakeExact(input, search.problem(), whole.objects, layout);
  search.set_layout(layout);
  result.score = search.Score();
  for (const Violation& violation : left) result.score += kInfeasible * (0.01 + violation.depth_m);
  result.evaluations += search.evaluations();
  for (int object : whole.objects) result.state.Place(object, layout[object]);
  return result;
}

}  // namespace flair::optimizer
