// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/polish.h"

#include <algorithm>

#include "optimizer_worker/stages/exact_step.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

namespace {

constexpr int kPolishSweeps = 2;
constexpr double kPolishNoise = 0.2;
constexpr CandidateDensity kSparse{.wall_samples = 2, .floor_samples = 10, .partner_samples = 1};

// The smaller partners of an object: what moves along when it moves.
std::vector<int> MembersOf(const SolveInput& input, const StageSpec& stage, int anchor) {
  std::vector<int> members;
  const double area = input.scene.objects[anchor].footprint.area_m2();
  for (int partner : input.partners[anchor]) {
    const bool moves = std::find(stage.objects.begin(), stage.objects.end(), partner) != stage.objects.end();
    if (moves && input.scene.objects[partner].footprint.area_m2() < area) members.push_back(partner);
  }
  return members;
}

// An object and up to two of its partners, or two strangers.
std::vector<int> Neighbourhood(const SolveInput& input, const StageSpec& stage, Random& random) {
  std::vector<int> chosen = {stage.objects[random.Below(static_cast<int>(stage.objects.size()))]};
  std::vector<int> pool;
  for (int partner : input.partners[chosen[0]]) {
    if (std::find(stage.objects.begin(), stage.objects.end(), partner) != stage.objects.end()) pool.push_back(partner);
  }
  if (pool.empty() || random.Uniform() < 0.3) pool = stage.objects;
  for (int extra = 1 + random.Below(2); extra > 0; --extra) {
    const int candidate = pool[random.Below(static_cast<int>(pool.size()))];
    if (std::find(chosen.begin(), chosen.end(), candidate) == chosen.end()) chosen.push_back(candidate);
  }
  return chosen;
}

void Improve(const SolveInput& input, const StageSpec& stage, LayoutSearch& search, Random& random) {
  search.Sweep(stage.objects, kPolishSweeps, kSparse, random);
  for (int anchor : stage.objects) {
    const std::vector<int> members = MembersOf(input, stage, anchor);
    if (!members.empty()) search.MoveTogether(anchor, members, kSparse, random);
  }
  const int attempts = 2 * static_cast<int>(stage.objects.size());
  for (int i = 0; i < attempts; ++i) search.Replace(Neighbourhood(input, stage, random), kPolishNoise, random);
}

// Descends from where `search` is, makes the layout exact and lets it settle. Returns the score.
double Finish(const SolveInput& input, const StageSpec& stage, const SearchInput& search_input, LayoutSearch& search) {
  search.Descend(stage.objects, {.max_evaluations = 60, .relative_tolerance = 1e-4, .absolute_tolerance = 1e-5});
  Layout layout = search.layout();
  const std::vector<Violation> left = MakeExact(input, search.problem(), stage.objects, layout);
  SearchInput settle_input = search_input;
  settle_input.walk_grid = &input.fine_walk_grid;
  LayoutSearch settled(settle_input, search.problem(), layout);
  std::vector<std::vector<int>> members_of;
  for (int object : stage.objects) members_of.push_back(MembersOf(input, stage, object));
  settled.Settle(stage.objects, members_of);
  double score = settled.Score();
  for (const Violation& violation : left) score += kInfeasible * (0.01 + violation.depth_m);
  search.set_layout(settled.layout());
  search.problem() = settled.problem();  // with its count of evaluations
  return score;
}

}  // namespace

RestartResult PolishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int restart,
                            int passes) {
  RestartResult result{restart, 0, 0, before};
  if (stage.objects.empty()) return result;
  Random random(RestartSeed(input.settings, stage, restart));
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, result.state.placed, result.state.layout);
    const SceneCosts costs = BindCosts(input, centers);
    const SearchInput search_input{input.scene,    input.partners,   centers, input.solver,
                                   input.keep_out, &input.walk_grid, {},      input.Over()};
    LayoutSearch search(search_input, MakeProblem(input, costs, stage, result.state), result.state.layout);
    if (!input.OutOfTime()) Improve(input, stage, search, random);
    if (pass + 1 == passes) result.score = Finish(input, stage, search_input, search);
    result.evaluations += search.evaluations();
    for (int object : stage.objects) result.state.Place(object, search.layout()[object]);
  }
  return result;
}

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
