// SPDX-License-Identifier: GPL-3.0-or-later
// Variants, the time limit and threads.
#include "optimizer_worker/stages/driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

// Two primaries and what goes with them.
v1::LayoutGraph Study() {
  return Parse(RoomText(4.5, 4) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.4, 2.0) +
               ObjectText("desk", "PRIMARY", "FLOOR", 1.2, 0.6) + ObjectText("chair", "SECONDARY", "FLOOR", 0.5, 0.5) +
               ObjectText("lamp", "TERTIARY", "SURFACE", 0.2, 0.2) + "}" +
               EdgeText("e1", "against_wall", Text("object", "bed")) +
               EdgeText("e2", "against_wall", Text("object", "desk")) +
               EdgeText("e3", "on_top_center", Text("object", "lamp") + Text("host", "desk")));
}

v1::SolvedLayout Solve(const v1::LayoutGraph& graph, const v1::SolveOptions& options) {
  absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? std::move(result->layout) : v1::SolvedLayout();
}

bool Differ(const google::protobuf::RepeatedPtrField<v1::Placement>& a,
            const google::protobuf::RepeatedPtrField<v1::Placement>& b, int leading) {
  Layout first, second;
  std::vector<int> objects;
  for (int i = 0; i < leading; ++i) {
    first.push_back({a[i].x_m(), a[i].y_m(), a[i].theta_rad()});
    second.push_back({b[i].x_m(), b[i].y_m(), b[i].theta_rad()});
    objects.push_back(i);
  }
  return DifferVisibly(objects, first, second);
}

TEST(Variants, AreCompleteAndDifferVisiblyBestFirst) {
  v1::SolveOptions options;
  options.set_variant_count(4);
  const v1::SolvedLayout layout = Solve(Study(), options);
  ASSERT_EQ(layout.runner_ups_size(), 3);
  for (int i = 0; i < 3; ++i) {
    const v1::RunnerUp& variant = layout.runner_ups(i);
    EXPECT_EQ(variant.placements_size(), 4);
    EXPECT_EQ(variant.edge_outcomes_size(), 3);
    EXPECT_EQ(variant.zone_regions_size(), 1);
    EXPECT_LT(variant.metrics().deepest_overlap_m(), 1e-6);
    EXPECT_GT(variant.metrics().reachable_floor_share(), 0);
    EXPECT_TRUE(Differ(layout.placements(), variant.placements(), 2));
    for (int k = 0; k < i; ++k) {
      EXPECT_TRUE(Differ(layout.runner_ups(k).placements(), variant.placements(), 2));
      EXPECT_LE(layout.runner_ups(k).cost(), variant.cost());
    }
  }
}

TEST(Variants, FewerThanAskedForAreSaidSo) {
  v1::LayoutGraph graph = Parse(RoomText(1.8, 2.4) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 0.7) +
                                "}" + EdgeText("e1", "against_wall", Text("object", "bed") + Text("wall", "north")));
  v1::SolveOptions options;
  options.set_variant_count(5);
  const v1::SolvedLayout layout = Solve(graph, options);
  ASSERT_LT(layout.runner_ups_size(), 4);
  ASSERT_GT(layout.diagnostics_size(), 0);
  EXPECT_EQ(layout.diagnostics(layout.diagnostics_size() - 1).code(), "fewer_variants");
}

TEST(Variants, DifferInTheRestWhereThePrimariesArePinned) {
  v1::LayoutGraph graph = Study();
  const v1::SolvedLayout first = Solve(graph, {});
  for (const v1::Placement& placement : first.placements()) {
    if (placement.object_id() != "chair" && placement.object_id() != "lamp") *graph.add_pinned_placements() = placement;
  }
  v1::SolveOptions options;
  options.set_variant_count(2);
  const v1::SolvedLayout layout = Solve(graph, options);
  ASSERT_EQ(layout.runner_ups_size(), 1);
  const std::vector<int> chair = {0};
  const auto pose = [](const v1::Placement& p) { return Layout{{p.x_m(), p.y_m(), p.theta_rad()}}; };
  EXPECT_TRUE(DifferVisibly(chair, pose(layout.placements(2)), pose(layout.runner_ups(0).placements(2))));
  EXPECT_EQ(layout.placements(0).x_m(), layout.runner_ups(0).placements(0).x_m());
}

TEST(Variants, AreBitIdenticalForAnyNumberOfThreads) {
  v1::SolveOptions options;
  options.set_variant_count(3);
  options.set_thread_count(1);
  const std::string one = Solve(Study(), options).SerializeAsString();
  for (int threads : {2, 3, 8}) {
    options.set_thread_count(threads);
    EXPECT_EQ(one, Solve(Study(), options).SerializeAsString()) << threads;
  }
}

// Runs restarts here and remembers those of the polish.
class RecordingRunner final : public RestartRunner {
 public:
  absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                 const PartialLayout& before, int first, int count) const override {
    absl::StatusOr<std::vector<RestartResult>> results = RunRestarts(input, stage, before, first, count);
    if (stage.kind != StageKind::kPolish || !results.ok()) return results;
    for (const RestartResult& result : *results) {
      (first == 0 ? beginnings_ : rounds_).push_back(result.restart);
      least_ = std::min(least_, result.score);
    }
    return results;
  }

  mutable std::vector<int> beginnings_, rounds_;
  mutable double least_ = std::numeric_limits<double>::infinity();
};

TEST(Polish, GoesOnInRoundsNumberedOnAndKeepsTheBest) {
  const v1::LayoutGraph graph = Study();
  const NloptSolver solver;
  v1::SolveOptions options;
  options.set_thread_count(1);
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, options, solver, nullptr);
  ASSERT_TRUE(input.ok()) << input.status();
  const RecordingRunner runner;
  absl::StatusOr<std::vector<Branch>> branches = Driver(*input, runner).Run();
  ASSERT_TRUE(branches.ok()) << branches.status();
  EXPECT_GE(runner.beginnings_.size(), 1u);
  // Two in a row without a gain end it, so there are two at least.
  ASSERT_GE(runner.rounds_.size(), 2u);
  for (size_t i = 0; i < runner.rounds_.size(); ++i) EXPECT_EQ(runner.rounds_[i], static_cast<int>(i) + 1);
  EXPECT_EQ(branches->front().score, runner.least_);
  const auto& outcomes = branches->front().outcomes;
  const auto polish =
      std::find_if(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.stage() == "polish"; });
  ASSERT_NE(polish, outcomes.end());
  EXPECT_EQ(polish->restart_count(), 1 + static_cast<int>(runner.rounds_.size()));
  EXPECT_EQ(polish->cost(), runner.least_);
}

TEST(Polish, TakesNoMoreRestartsThanTheCallerSays) {
  v1::SolveOptions options;
  options.set_max_restart_count(2);
  const v1::SolvedLayout layout = Solve(Study(), options);
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) EXPECT_LE(outcome.restart_count(), 2);
}

TEST(TimeLimit, EndsWithACompleteLayoutAndSaysSo) {
  v1::SolveOptions options;
  options.set_thread_count(1);
  options.mutable_time_limit()->set_nanos(1);
  const v1::SolvedLayout layout = Solve(Study(), options);
  EXPECT_EQ(layout.placements_size(), 4);
  EXPECT_LT(layout.metrics().deepest_overlap_m(), 1e-6);
  ASSERT_GT(layout.stage_outcomes_size(), 0);
  EXPECT_TRUE(layout.stage_outcomes(0).stopped_early());
  ASSERT_GT(layout.diagnostics_size(), 0);
  EXPECT_EQ(layout.diagnostics(layout.diagnostics_size() - 1).code(), "time_limit");
}

TEST(TimeLimit, ThatIsNotReachedChangesNothing) {
  v1::SolveOptions options;
  const std::string without = Solve(Study(), options).SerializeAsString();
  options.mutable_time_limit()->set_seconds(3600);
  EXPECT_EQ(without, Solve(Study(), options).SerializeAsString());
}

TEST(Driver, StopsWithinOneRestartWhenCancelledOnTheWay) {
  std::atomic<int> polls = 0;
  v1::SolveOptions options;
  options.set_thread_count(1);
  const auto result = SolveLayout(Study(), options, NloptSolver(), [&] { return ++polls > 5; });
  EXPECT_EQ(result.status().code(), absl::StatusCode::kCancelled);
  // The restart that was running, the remaining polls of its stage, and no more stages.
  EXPECT_LT(polls, 20);
}

TEST(Driver, StopsInTheMiddleOfARestart) {
  // One stage with one restart: without polls on the way it would run to its end.
  v1::SolveOptions options;
  options.set_thread_count(1);
  options.set_max_restart_count(1);
  for (int most : {1, 10, 40}) {
    int polls = 0;
    const auto result = SolveLayout(Study(), options, NloptSolver(), [&] { return ++polls > most; });
    EXPECT_EQ(result.status().code(), absl::StatusCode::kCancelled) << most;
    EXPECT_LT(polls, most + 20);
  }
}

}  // namespace
}  // namespace flair::optimizer
