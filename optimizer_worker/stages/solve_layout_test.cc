// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/testing/graphs.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

SolveResult Solve(const v1::LayoutGraph& graph, int threads = 1, int64_t seed = 0) {
  v1::SolveOptions options;
  options.set_thread_count(threads);
  options.set_seed(seed);
  absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? *std::move(result) : SolveResult{};
}

TEST(SolveLayout, FurnishesABedroomAsItsConstraintsSay) {
  for (int seed : {0, 1, 2}) {
    const v1::SolvedLayout layout = Solve(Bedroom(), 1, seed).layout;
    ASSERT_EQ(layout.edge_outcomes_size(), 5);
    for (int e = 0; e < 4; ++e) {
      EXPECT_EQ(layout.edge_outcomes(e).status(), v1::OUTCOME_STATUS_SATISFIED)
          << seed << ": " << layout.edge_outcomes(e).ShortDebugString();
    }
    EXPECT_EQ(layout.diagnostics_size(), 0) << layout.diagnostics(0).message();
    const v1::Placement& nightstand = PlacementOf(layout, "nightstand");
    const v1::Placement& lamp = PlacementOf(layout, "lamp");
    EXPECT_NEAR(lamp.x_m(), nightstand.x_m(), 0.05);
    EXPECT_NEAR(lamp.y_m(), nightstand.y_m(), 0.05);
    EXPECT_NEAR(lamp.z_m(), 0.6, 1e-9);
    EXPECT_NEAR(PlacementOf(layout, "picture").z_m(), 1.5, 1e-9);
  }
}

TEST(SolveLayout, ACallThatCannotBeBoundIsDroppedWithTheReason) {
  const v1::SolvedLayout layout = Solve(Bedroom()).layout;
  EXPECT_EQ(layout.edge_outcomes(4).status(), v1::OUTCOME_STATUS_DROPPED);
  EXPECT_NE(layout.edge_outcomes(4).reason().find("no_such_type"), std::string::npos);
}

TEST(SolveLayout, IsBitIdenticalForAnyNumberOfThreads) {
  const std::string one = Solve(Bedroom(), 1).layout.SerializeAsString();
  EXPECT_EQ(one, Solve(Bedroom(), 4).layout.SerializeAsString());
  EXPECT_EQ(one, Solve(Bedroom(), 3).layout.SerializeAsString());
}

TEST(SolveLayout, SaysWhatDoesNotFit) {
  const v1::LayoutGraph graph =
      Parse(RoomText(2, 2) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 2.0) +
            ObjectText("wardrobe", "SECONDARY", "FLOOR", 1.5, 0.6) + "}");
  const v1::SolvedLayout layout = Solve(graph).layout;
  EXPECT_EQ(layout.placements_size(), 2);
  ASSERT_GT(layout.diagnostics_size(), 0);
  EXPECT_EQ(layout.diagnostics(0).code(), "does_not_fit");
}

TEST(SolveLayout, RejectsAGraphThatDoesNotValidate) {
  const absl::StatusOr<SolveResult> result = SolveLayout(Parse(RoomText(3, 3)), {}, NloptSolver());
  EXPECT_EQ(result.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_NE(result.status().message().find("object_list"), absl::string_view::npos) << result.status();
}

TEST(SolveLayout, StopsWhenCancelled) {
  const absl::StatusOr<SolveResult> result = SolveLayout(Bedroom(), {}, NloptSolver(), [] { return true; });
  EXPECT_EQ(result.status().code(), absl::StatusCode::kCancelled);
}

TEST(SolveLayout, RejectsOptionsOutOfRange) {
  v1::SolveOptions options;
  options.set_max_restart_count(0);
  EXPECT_EQ(SolveLayout(Bedroom(), options, NloptSolver()).status().code(), absl::StatusCode::kInvalidArgument);
  options.Clear();
  options.mutable_lambdas()->set_zone(std::nan(""));
  EXPECT_EQ(SolveLayout(Bedroom(), options, NloptSolver()).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(SolveStageRestarts, ASplitRangeGivesTheSameRestarts) {
  v1::SolveRestartsRequest request;
  *request.mutable_layout_graph() = Bedroom();
  request.set_stage("primary");
  request.set_restart_count(4);
  const NloptSolver solver;
  const auto whole = SolveStageRestarts(request, solver);
  ASSERT_TRUE(whole.ok()) << whole.status();
  request.set_first_restart(2);
  request.set_restart_count(2);
  const auto half = SolveStageRestarts(request, solver);
  ASSERT_TRUE(half.ok()) << half.status();
  EXPECT_EQ((*whole)[2].SerializeAsString(), (*half)[0].SerializeAsString());
  EXPECT_EQ((*whole)[3].SerializeAsString(), (*half)[1].SerializeAsString());
}

TEST(EvaluateLayout, EdgesOnMissingObjectsComeBackDropped) {
  v1::EvaluateRequest request;
  *request.mutable_layout_graph() = Bedroom();
  v1::Placement* bed = request.add_placements();
  bed->set_object_id("bed");
  bed->set_x_m(2.5);
  bed->set_y_m(3.0);
  bed->set_theta_rad(kPi);
  const auto response = EvaluateLayout(request, NloptSolver());
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->edge_outcomes(0).status(), v1::OUTCOME_STATUS_SATISFIED)
      << response->edge_outcomes(0).ShortDebugString();
  EXPECT_EQ(response->edge_outcomes(1).status(), v1::OUTCOME_STATUS_DROPPED);
}

}  // namespace
}  // namespace flair::optimizer
