// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

// A room of 2.6 m x 2.6 m that holds the bed and one wardrobe, but not two.
v1::LayoutGraph Crowded() {
  return Parse(RoomText(2.6, 2.6) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.4, 2.0) +
               ObjectText("asked_for", "SECONDARY", "FLOOR", 0.9, 0.5) +
               ObjectText("wardrobe", "SECONDARY", "FLOOR", 1.9, 0.9) +
               ObjectText("box", "TERTIARY", "SURFACE", 0.3, 0.3) + "}" +
               EdgeText("e1", "against_wall", Text("object", "wardrobe")) +
               EdgeText("e2", "on_top_center", Text("object", "box") + Text("host", "wardrobe")));
}

v1::SolvedLayout Solve(const v1::LayoutGraph& graph, v1::MisfitPolicy policy) {
  v1::SolveOptions options;
  options.set_misfit_policy(policy);
  absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? std::move(result->layout) : v1::SolvedLayout();
}

bool IsPlaced(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == id) return true;
  }
  return false;
}

TEST(LeaveOut, KeepsAllWhenAskedToAndNamesTheCulprit) {
  const v1::SolvedLayout layout = Solve(Crowded(), v1::MISFIT_POLICY_KEEP);
  EXPECT_EQ(layout.placements_size(), 4);
  ASSERT_GT(layout.diagnostics_size(), 0);
  EXPECT_EQ(layout.diagnostics(0).code(), "does_not_fit");
}

TEST(LeaveOut, LeavesOutTheLeastImportantAndSaysWhy) {
  v1::LayoutGraph graph = Crowded();
  graph.mutable_object_list()->mutable_objects(1)->set_requested(true);
  graph.mutable_object_list()->mutable_objects(3)->set_host_id("wardrobe");
  const v1::SolvedLayout layout = Solve(graph, v1::MISFIT_POLICY_LEAVE_OUT);
  EXPECT_TRUE(IsPlaced(layout, "bed"));
  EXPECT_TRUE(IsPlaced(layout, "asked_for"));
  EXPECT_FALSE(IsPlaced(layout, "wardrobe"));
  EXPECT_FALSE(IsPlaced(layout, "box"));
  EXPECT_LT(layout.metrics().deepest_overlap_m(), 1e-6);
  ASSERT_EQ(layout.diagnostics_size(), 2);
  EXPECT_EQ(layout.diagnostics(0).code(), "left_out");
  EXPECT_NE(layout.diagnostics(0).message().find("no free place of 1.90 m x 0.90 m; the largest free one is"),
            std::string::npos)
      << layout.diagnostics(0).message();
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    EXPECT_EQ(outcome.status(), v1::OUTCOME_STATUS_DROPPED);
    EXPECT_NE(outcome.reason().find("is left out"), std::string::npos) << outcome.reason();
  }
}

TEST(LeaveOut, ChangesNothingWhereEverythingFits) {
  EXPECT_EQ(Solve(Bedroom(), v1::MISFIT_POLICY_KEEP).SerializeAsString(),
            Solve(Bedroom(), v1::MISFIT_POLICY_LEAVE_OUT).SerializeAsString());
}

TEST(LeaveOut, AnObjectLargerThanTheRoomLeavesAnEmptyRoom) {
  const v1::LayoutGraph graph =
      Parse(RoomText(3, 3) + "object_list {" + ObjectText("hangar", "PRIMARY", "FLOOR", 12, 9) + "}");
  const v1::SolvedLayout layout = Solve(graph, v1::MISFIT_POLICY_LEAVE_OUT);
  EXPECT_EQ(layout.placements_size(), 0);
  ASSERT_EQ(layout.diagnostics_size(), 1);
  EXPECT_EQ(layout.diagnostics(0).code(), "left_out");
}

TEST(LeaveOut, APrimaryStaysRatherThanWhatWouldFitInItsPlace) {
  // Two chests fit beside each other, or the bed and one of them.
  const v1::LayoutGraph graph = Parse(
      RoomText(2.2, 2.9) + "object_list {" + ObjectText("chest_1", "SECONDARY", "FLOOR", 1.9, 0.8) +
      ObjectText("chest_2", "SECONDARY", "FLOOR", 1.9, 0.8) + ObjectText("bed", "PRIMARY", "FLOOR", 1.3, 2.0) + "}");
  const v1::SolvedLayout layout = Solve(graph, v1::MISFIT_POLICY_LEAVE_OUT);
  EXPECT_TRUE(IsPlaced(layout, "bed"));
  EXPECT_FALSE(IsPlaced(layout, "chest_1") && IsPlaced(layout, "chest_2"));
  EXPECT_LT(layout.metrics().deepest_overlap_m(), 1e-6);
}

TEST(LeaveOut, NeverLeavesOutWhatIsPinned) {
  v1::LayoutGraph graph = Crowded();
  v1::Placement* pin = graph.add_pinned_placements();
  pin->set_object_id("wardrobe");
  pin->set_x_m(1.5);
  pin->set_y_m(2.1);
  const v1::SolvedLayout layout = Solve(graph, v1::MISFIT_POLICY_LEAVE_OUT);
  EXPECT_TRUE(IsPlaced(layout, "wardrobe"));
  EXPECT_LT(layout.metrics().deepest_overlap_m(), 1e-6);
}

// A bed in a room just as wide, so that nothing stands beside its head, a nightstand with its lamp, and a chest.
v1::LayoutGraph NarrowBedroom() {
  v1::LayoutGraph graph =
      Parse(RoomText(1.9, 5) + "object_list {" + ObjectText("bed", "PRIMARY", "FLOOR", 1.6, 2.0) +
            ObjectText("nightstand", "SECONDARY", "FLOOR", 0.5, 0.4) +
            ObjectText("lamp", "TERTIARY", "SURFACE", 0.2, 0.2) + ObjectText("chest", "SECONDARY", "FLOOR", 0.8, 0.4) +
            "}" + EdgeText("e1", "against_wall", Text("object", "bed")) +
            EdgeText("e2", "next_to",
                     Text("object", "nightstand") + Text("target", "bed") + Text("object_side", "right") +
                         Text("target_side", "left")) +
            EdgeText("e3", "on_top_center", Text("object", "lamp") + Text("host", "nightstand")) +
            EdgeText("e4", "against_wall", Text("object", "chest")));
  for (v1::Object& object : *graph.mutable_object_list()->mutable_objects()) object.set_spare(object.id() != "bed");
  return graph;
}

TEST(LeaveOut, ASparePieceWithoutAGoodPlaceGoesWithWhatItCarries) {
  const v1::SolvedLayout layout = Solve(NarrowBedroom(), v1::MISFIT_POLICY_KEEP);
  EXPECT_FALSE(IsPlaced(layout, "nightstand"));
  EXPECT_FALSE(IsPlaced(layout, "lamp"));
  EXPECT_TRUE(IsPlaced(layout, "bed"));
  EXPECT_TRUE(IsPlaced(layout, "chest"));
  ASSERT_EQ(layout.diagnostics_size(), 2);
  EXPECT_EQ(layout.diagnostics(0).code(), "left_out");
  EXPECT_EQ(layout.diagnostics(0).severity(), v1::SEVERITY_NOTE);
  EXPECT_NE(layout.diagnostics(0).message().find("nobody asked for it, and no place was found where"),
            std::string::npos)
      << layout.diagnostics(0).message();
}

TEST(LeaveOut, NothingSpareStaysOutThatWasAskedForOrCarriesSuchAThing) {
  v1::LayoutGraph asked = NarrowBedroom();
  asked.mutable_object_list()->mutable_objects(1)->set_requested(true);
  EXPECT_TRUE(IsPlaced(Solve(asked, v1::MISFIT_POLICY_KEEP), "nightstand"));
  v1::LayoutGraph carries = NarrowBedroom();
  carries.mutable_object_list()->mutable_objects(2)->set_requested(true);
  EXPECT_TRUE(IsPlaced(Solve(carries, v1::MISFIT_POLICY_KEEP), "nightstand"));
}

TEST(LeaveOut, ASparePieceInTheWayOfAnotherGoes) {
  // Only without the spare chest there are 1.4 m of free floor before the desk.
  v1::LayoutGraph graph =
      Parse(RoomText(2, 3) + "object_list {" + ObjectText("desk", "PRIMARY", "FLOOR", 1.9, 0.7) +
            ObjectText("chest", "SECONDARY", "FLOOR", 1.8, 0.6) + "}" +
            EdgeText("e1", "against_wall", Text("object", "desk")) +
            EdgeText("e2", "accessible",
                     Text("object", "desk") + R"(arguments { name: "min_clearance_m" value { number: 1.4 } })"));
  graph.mutable_object_list()->mutable_objects(1)->set_spare(true);
  const v1::SolvedLayout layout = Solve(graph, v1::MISFIT_POLICY_KEEP);
  EXPECT_TRUE(IsPlaced(layout, "desk"));
  EXPECT_FALSE(IsPlaced(layout, "chest"));
}

}  // namespace
}  // namespace flair::optimizer
