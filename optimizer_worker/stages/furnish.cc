// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/furnish.h"

#include <algorithm>

namespace flair::optimizer {
namespace {

constexpr int kSweeps = 3;
constexpr double kNoise = 0.3;

std::vector<int> OrderOf(const StageSpec& stage, int restart, Random& random) {
  std::vector<int> order = stage.objects;
  if (restart == 0) return order;
  for (int i = static_cast<int>(order.size()) - 1; i > 0; --i) std::swap(order[i], order[random.Below(i + 1)]);
  return order;
}

}  // namespace

RestartResult FurnishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before,
                             int restart) {
  Random random(RestartSeed(input.settings, stage, restart));
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, before.placed, before.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input{input.scene,    input.partners,   centers, input.solver,
                                 input.keep_out, &input.walk_grid, {},      input.Over()};
  LayoutSearch search(search_input, MakeProblem(input, costs, stage, before), before.layout);

  search.Construct(OrderOf(stage, restart, random), restart == 0 ? 0.0 : kNoise, random);
  search.Sweep(stage.objects, kSweeps, CandidateDensity{}, random);
  const Layout swept = search.layout();
  const double swept_score = search.Score();
  search.Descend(stage.objects, {.max_evaluations = 40, .relative_tolerance = 1e-3, .absolute_tolerance = 1e-4});
  double score = search.Score();
  if (score > swept_score) {
    search.set_layout(swept);
    score = swept_score;
  }
  RestartResult result{restart, score, search.evaluations(), before};
  for (int object : stage.objects) result.state.Place(object, search.layout()[object]);
  return result;
}

}  // namespace flair::optimizer
