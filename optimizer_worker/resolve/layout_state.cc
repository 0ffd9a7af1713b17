// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/layout_state.h"

#include <algorithm>

#include "optimizer_worker/stages/exact_step.h"
#include "optimizer_worker/stages/fit_diagnostics.h"
#include "optimizer_worker/stages/outcomes.h"
#include "optimizer_worker/stages/polish.h"

namespace flair::optimizer {
namespace {

void AddOnce(std::vector<int>& list, int value) {
  const auto place = std::lower_bound(list.begin(), list.end(), value);
  if (place == list.end() || *place != value) list.insert(place, value);
}

SceneCosts CostsOf(const SolveInput& input, const PartialLayout& state) {
  return BindCosts(input, ZoneCenters(input.scene, state.placed, state.layout));
}

bool Satisfied(const Term& term, const PartialLayout& state) {
  std::vector<Pose<double>> poses;
  for (int object : term.cost->objects()) poses.push_back(state.layout[object]);
  return term.cost->Value(poses) <= kSatisfiedCost;
}

}  // namespace

Grievances FindGrievances(const SolveInput& input, const PartialLayout& state, const Baseline& baseline) {
  Grievances grievances;
  const auto solid = [&](int object) { return object < 0 || IsSolid(input.scene.objects[object]); };
  const SceneCosts costs = CostsOf(input, state);
  for (const Misfit& misfit : FindMisfits(input, costs, state)) {
    if (baseline.tolerated.contains({misfit.object, misfit.other})) continue;
    // Where the user has put things into each other or through a wall, nobody can help.
    if (input.pinned[misfit.object] && (misfit.other < 0 || input.pinned[misfit.other])) continue;
    const bool on_floor = solid(misfit.object) && solid(misfit.other);
    if (on_floor) grievances.depth_m += misfit.depth_m;
    for (int object : {misfit.object, misfit.other}) {
      if (object < 0 || input.pinned[object]) continue;
      if (on_floor) AddOnce(grievances.colliding, object);
      // Where something on a wall meets something on the floor, the first gives way.
      if (!solid(object)) AddOnce(grievances.astray, object);
    }
  }
  for (const Term& term : costs.terms) {
    if (term.edge < 0 || !baseline.held[term.edge]) continue;
    const bool there =
        std::all_of(term.required.begin(), term.required.end(), [&](int object) { return state.placed[object] != 0; });
    if (there && !Satisfied(term, state)) grievances.broken.push_back(term.edge);
  }
  return grievances;
}

std::set<std::pair<int, int>> PairsInTheWay(const SolveInput& input, const PartialLayout& state) {
  std::set<std::pair<int, int>> pairs;
  for (const Misfit& misfit : FindMisfits(input, CostsOf(input, state), state)) {
    pairs.emplace(misfit.object, misfit.other);
  }
  return pairs;
}

double ScoreOf(const SolveInput& input, const StageSpec& stage, const PartialLayout& state) {
  const bool floor = stage.kind != StageKind::kTertiary;
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, state.placed, state.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input{
      input.scene, input.partners, centers, input.solver, input.keep_out, floor ? &input.walk_grid : nullptr, {}};
  LayoutSearch search(search_input, MakeProblem(input, costs, stage, state), state.layout);
  double score = search.Score();
  if (!floor) return score;
  std::vector<int> standing;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (state.placed[i]) standing.push_back(i);
  }
  for (const Violation& violation : FindViolations(input.scene, input.keep_out, standing, state.layout, kTouching_m)) {
    score += kInfeasible * (0.01 + violation.depth_m);
  }
  return score;
}

}  // namespace flair::optimizer
