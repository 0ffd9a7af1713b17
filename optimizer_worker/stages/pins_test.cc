// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/stage.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

void Pin(v1::LayoutGraph& graph, const char* id, double x_m, double y_m, double theta_rad) {
  v1::Placement* pin = graph.add_pinned_placements();
  pin->set_object_id(id);
  pin->set_x_m(x_m);
  pin->set_y_m(y_m);
  pin->set_theta_rad(theta_rad);
}

v1::SolvedLayout Solve(const v1::LayoutGraph& graph) {
  absl::StatusOr<SolveResult> result = SolveLayout(graph, {}, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? std::move(result->layout) : v1::SolvedLayout();
}

TEST(Pins, StandWhereTheyArePutWhateverTheirRole) {
  v1::LayoutGraph graph = Bedroom();
  Pin(graph, "bed", 2.6, 1.25, 1.25);
  Pin(graph, "nightstand", 0.5, 3.25, 0.5);
  Pin(graph, "picture", 0.025, 2.125, 4.75);
  const v1::SolvedLayout layout = Solve(graph);
  for (const v1::Placement& pin : graph.pinned_placements()) {
    const v1::Placement& placed = PlacementOf(layout, pin.object_id());
    EXPECT_EQ(placed.x_m(), pin.x_m()) << pin.object_id();
    EXPECT_EQ(placed.y_m(), pin.y_m()) << pin.object_id();
    EXPECT_EQ(placed.theta_rad(), pin.theta_rad()) << pin.object_id();
  }
  // What is free still follows its constraints.
  EXPECT_EQ(layout.edge_outcomes(3).status(), v1::OUTCOME_STATUS_SATISFIED);
}

TEST(Pins, OthersFitAroundThem) {
  v1::LayoutGraph graph = Bedroom();
  Pin(graph, "nightstand", 2, 2, 0);
  const v1::SolvedLayout layout = Solve(graph);
  EXPECT_EQ(layout.diagnostics_size(), 0) << layout.diagnostics(0).message();
  EXPECT_LT(layout.metrics().deepest_overlap_m(), 1e-6);
}

TEST(Pins, ThatOverlapOrStickOutAreRemarksAndNoErrors) {
  v1::LayoutGraph graph = Bedroom();
  Pin(graph, "bed", 3.5, 3, 0);
  Pin(graph, "nightstand", 3.2, 3, 0);
  const v1::SolvedLayout layout = Solve(graph);
  int collisions = 0;
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) {
    EXPECT_EQ(diagnostic.code(), "pinned_collides") << diagnostic.message();
    ++collisions;
  }
  EXPECT_EQ(collisions, 2);
}

TEST(Pins, ThatNameNobodyOrNowhereAreRejected) {
  for (const char* wrong : {"ghost", "bed"}) {
    v1::LayoutGraph graph = Bedroom();
    Pin(graph, wrong, 40, 2, 0);
    const absl::Status status = SolveLayout(graph, {}, NloptSolver()).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_NE(status.message().find("pinned_placements[0]"), absl::string_view::npos) << status;
  }
}

TEST(Pins, RestartsOfAStageLeaveThemOut) {
  v1::SolveRestartsRequest request;
  *request.mutable_layout_graph() = Bedroom();
  Pin(*request.mutable_layout_graph(), "bed", 2, 2, 0);
  request.set_stage("polish");
  request.set_restart_count(1);
  v1::Placement* nightstand = request.add_placements();
  nightstand->set_object_id("nightstand");
  nightstand->set_x_m(3.5);
  nightstand->set_y_m(3.5);
  const auto outcomes = SolveStageRestarts(request, NloptSolver());
  ASSERT_TRUE(outcomes.ok()) << outcomes.status();
  ASSERT_EQ((*outcomes)[0].placements_size(), 1);
  EXPECT_EQ((*outcomes)[0].placements(0).object_id(), "nightstand");
}

}  // namespace
}  // namespace flair::optimizer
