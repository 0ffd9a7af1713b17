// SPDX-License-Identifier: GPL-3.0-or-later
// Halls of a hundred pieces: no single call of the solver is so large that neither a time limit nor a caller who has
// gone could end it, and little is done once time is up.
#include <gtest/gtest.h>

#include <algorithm>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/floor_stages.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/stage.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

constexpr int kPieces = 100;

v1::LayoutGraph Hall(double side_m) {
  std::string text = RoomText(side_m, side_m) + "object_list {";
  for (int i = 0; i < kPieces; ++i) {
    text += ObjectText(fmt::format("piece_{}", i).c_str(), i < 4 ? "PRIMARY" : "SECONDARY", "FLOOR", 0.5, 0.4);
  }
  return Parse(text + "}");
}

// What was asked of the solver.
class Spy final : public Solver {
 public:
  SolverReport Minimize(Objective& objective, const Bounds& bounds, const SolverLimits& limits,
                        std::span<double> x) const override {
    most_variables = std::max(most_variables, x.size());
    variables += x.size();
    largest_program = std::max(largest_program, x.size() * bounds.inequalities.size());
    return solver_.Minimize(objective, bounds, limits, x);
  }
  mutable size_t most_variables = 0, variables = 0, largest_program = 0;

 private:
  NloptSolver solver_;
};

// Everything on a grid, a little askew.
PartialLayout OnAGrid(const Scene& scene, double side_m) {
  PartialLayout state(scene);
  for (int i = 0; i < kPieces; ++i) {
    state.Place(i, {side_m * (0.1 + 0.09 * (i % 10)), side_m * (0.1 + 0.09 * (i / 10)), 0.03 * (i % 7)});
  }
  return state;
}

TEST(ManyObjects, DescendAPartAtATimeAndAllOfThemDo) {
  const v1::LayoutGraph graph = Hall(12);
  const Spy spy;
  const absl::StatusOr<SolveInput> input = MakeSolveInput(graph, {}, spy, nullptr);
  ASSERT_TRUE(input.ok()) << input.status();
  const PartialLayout state = OnAGrid(input->scene, 12);
  const StageSpec stage = MakeStage(input->scene, StageKind::kPolish);
  const std::vector<Vec2<double>> centers = ZoneCenters(input->scene, state.placed, state.layout);
  const SceneCosts costs = BindCosts(*input, centers);
  const SearchInput search_input{input->scene, input->partners, centers, spy, input->keep_out, nullptr, {}, nullptr};
  LayoutSearch search(search_input, MakeProblem(*input, costs, stage, state), state.layout);
  const double before = search.Cost();
  search.Descend(stage.objects, {.max_evaluations = 10});
  EXPECT_LT(search.Cost(), before);
  EXPECT_LE(spy.most_variables, 180u);
  EXPECT_EQ(spy.variables, 3u * kPieces);
}

TEST(ManyObjects, AreMadeExactWithoutAProgramThatTakesSeconds) {
  const v1::LayoutGraph graph = Hall(6);
  const Spy spy;
  const absl::StatusOr<SolveInput> input = MakeSolveInput(graph, {}, spy, nullptr);
  ASSERT_TRUE(input.ok()) << input.status();
  PartialLayout state = OnAGrid(input->scene, 6);
  const StageSpec stage = MakeStage(input->scene, StageKind::kPolish);
  const SceneCosts costs = BindCosts(*input, state);
  Problem problem = MakeProblem(*input, costs, stage, state);
  EXPECT_TRUE(MakeExact(*input, problem, stage.objects, state.layout).empty());
  EXPECT_LE(spy.largest_program, 150000u);
}

TEST(ManyObjects, StopSoonAfterTimeIsUp) {
  const v1::LayoutGraph graph = Hall(12);
  const NloptSolver solver;
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, {}, solver, nullptr);
  ASSERT_TRUE(input.ok()) << input.status();
  input->settings.threads = 1;
  // Time is up from the beginning: each piece is placed once, and the result is made exact.
  input->out_of_time = [] { return true; };
  const absl::StatusOr<std::vector<Branch>> branches = Driver(*input, LocalRestartRunner()).Run();
  ASSERT_TRUE(branches.ok()) << branches.status();
  const Branch& best = branches->front();
  int64_t evaluations = 0;
  for (const v1::StageOutcome& outcome : best.outcomes) evaluations += outcome.evaluation_count();
  EXPECT_LT(evaluations, 1000 * kPieces);
  EXPECT_EQ(std::count(best.state.placed.begin(), best.state.placed.end(), 1), kPieces);
}

}  // namespace
}  // namespace flair::optimizer
