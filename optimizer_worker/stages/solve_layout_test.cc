// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fmt/format.h"
#include "google/protobuf/text_format.h"
#include "optimizer_worker/solver/nlopt_solver.h"
#include "optimizer_worker/stages/evaluate_layout.h"
#include "optimizer_worker/stages/solve_stage_restarts.h"
#include "room/geometry/angle.h"

namespace flair::optimizer {
namespace {

v1::LayoutGraph Parse(const std::string& text) {
  v1::LayoutGraph graph;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &graph));
  return graph;
}

std::string RoomText(double width_m, double depth_m) {
  return fmt::format(
      R"(room {{
        room_type: "bedroom"
        floor {{ vertices {{}} vertices {{ x_m: {0} }} vertices {{ x_m: {0} y_m: {1} }} vertices {{ y_m: {1} }} }}
        walls {{ name: "south" }} walls {{ name: "east" }} walls {{ name: "north" }} walls {{ name: "west" }}
        height_m: 3
        openings {{ id: "door_1" kind: OPENING_KIND_DOOR wall: "south" offset_m: 0.1 width_m: 0.8 head_height_m: 2.1
                    leaf {{ hinge: HINGE_SIDE_START swing: DOOR_SWING_INWARD swing_angle_rad: 1.5707963 }} }}
      }}
      zone_plan {{ zones {{ id: "sleeping" name: "sleeping" }} }})",
      width_m, depth_m);
}

std::string ObjectText(const char* id, const char* role, const char* kind, double width_m, double depth_m) {
  return fmt::format(R"(objects {{ id: "{0}" name: "{0}" role: OBJECT_ROLE_{1} kind: OBJECT_KIND_{2} zone_id: "sleeping"
                                   width_m: {3} depth_m: {4} height_m: 0.6 elevation_m: {5} }})",
                     id, role, kind, width_m, depth_m, std::string(kind) == "WALL" ? 1.5 : 0.0);
}

std::string EdgeText(const char* id, const char* type, const std::string& arguments) {
  return fmt::format(R"(edges {{ id: "{}" type: "{}" weight: 1 {} }})", id, type, arguments);
}

std::string Text(const char* name, const char* value) {
  return fmt::format(R"(arguments {{ name: "{}" value {{ text: "{}" }} }})", name, value);
}

// A bed with its head to a wall, a nightstand at its left, a picture above it, a lamp on the nightstand.
v1::LayoutGraph Bedroom() {
  return Parse(RoomText(4, 4) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 2.0) +
               ObjectText("nightstand", "SECONDARY", "FLOOR", 0.5, 0.4) +
               ObjectText("picture", "TERTIARY", "WALL", 0.8, 0.05) +
               ObjectText("lamp", "TERTIARY", "SURFACE", 0.2, 0.2) + "}" +
               EdgeText("e1", "against_wall", Text("object", "bed")) +
               EdgeText("e2", "next_to",
                        Text("object", "nightstand") + Text("target", "bed") + Text("object_side", "right") +
                            Text("target_side", "left")) +
               EdgeText("e3", "on_wall_above", Text("object", "picture") + Text("target", "bed")) +
               EdgeText("e4", "on_top_center", Text("object", "lamp") + Text("host", "nightstand")) +
               EdgeText("e5", "no_such_type", Text("object", "bed")));
}

SolveResult Solve(const v1::LayoutGraph& graph, int threads = 1, int64_t seed = 0) {
  v1::SolveOptions options;
  options.set_thread_count(threads);
  options.set_seed(seed);
  absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? *std::move(result) : SolveResult{};
}

const v1::Placement& PlacementOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == id) return placement;
  }
  ADD_FAILURE() << id << " is not placed";
  return v1::Placement::default_instance();
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
