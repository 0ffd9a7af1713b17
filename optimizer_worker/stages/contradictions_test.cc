// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/infeasible.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

v1::SolvedLayout Solve(const v1::LayoutGraph& graph) {
  v1::SolveOptions options;
  options.set_find_contradictions(true);
  absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? std::move(result->layout) : v1::SolvedLayout();
}

std::string Number(const char* name, double value) {
  return fmt::format(R"(arguments {{ name: "{}" value {{ number: {} }} }})", name, value);
}

std::vector<std::string> Group(const v1::Contradiction& contradiction) {
  return {contradiction.edge_ids().begin(), contradiction.edge_ids().end()};
}

std::string Desk(const std::string& edges) {
  return RoomText(3, 3) + "object_list {" + ObjectText("desk", "PRIMARY", "FLOOR", 1.2, 0.6) +
         ObjectText("shelf", "SECONDARY", "FLOOR", 0.8, 0.3) + "}" + edges;
}

TEST(Contradictions, ADistanceThatTheRoomDoesNotHaveIsAGroupOfOne) {
  const v1::SolvedLayout layout =
      Solve(Parse(Desk(EdgeText("e1", "against_wall", Text("object", "desk")) +
                       EdgeText("e2", "away_from_feature",
                                Text("object", "desk") + Text("feature", "door") + Number("min_distance_m", 5)))));
  ASSERT_EQ(layout.contradictions_size(), 1);
  EXPECT_EQ(Group(layout.contradictions(0)), std::vector<std::string>{"e2"});
  EXPECT_NE(layout.contradictions(0).explanation().find("cannot hold in this room"), std::string::npos);
}

TEST(Contradictions, AreMinimal) {
  // The desk cannot have its back on two walls; where the shelf stands has nothing to do with it.
  const v1::SolvedLayout layout =
      Solve(Parse(Desk(EdgeText("e1", "against_wall", Text("object", "desk") + Text("wall", "north")) +
                       EdgeText("e2", "against_wall", Text("object", "desk") + Text("wall", "west")) +
                       EdgeText("e3", "near", Text("object", "shelf") + Text("target", "desk")) +
                       EdgeText("e4", "against_wall", Text("object", "shelf")))));
  ASSERT_EQ(layout.contradictions_size(), 1);
  EXPECT_EQ(Group(layout.contradictions(0)), (std::vector<std::string>{"e1", "e2"}));
}

TEST(Contradictions, AreNotFoundWhereAllHoldsNorSoughtUnasked) {
  EXPECT_EQ(Solve(Bedroom()).contradictions_size(), 0);
  const v1::LayoutGraph graph =
      Parse(Desk(EdgeText("e1", "against_wall", Text("object", "desk") + Text("wall", "north")) +
                 EdgeText("e2", "against_wall", Text("object", "desk") + Text("wall", "west"))));
  EXPECT_EQ(SolveLayout(graph, {}, NloptSolver())->layout.contradictions_size(), 0);
}

}  // namespace
}  // namespace flair::optimizer
