// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/tertiary.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

v1::SolvedLayout Solve(const v1::LayoutGraph& graph, int64_t seed) {
  v1::SolveOptions options;
  options.set_seed(seed);
  absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? std::move(result->layout) : v1::SolvedLayout();
}

std::string OnTop(const char* id, const char* what, const char* host = "stool") {
  return EdgeText(id, "on_top_center", Text("object", what) + Text("host", host));
}

v1::LayoutGraph Stool(double width_m, const std::string& things, const std::string& edges) {
  return Parse(RoomText(4, 4) + "object_list {" + ObjectText("stool", "PRIMARY", "FLOOR", width_m, width_m) + things +
               "}" + edges);
}

// All want the middle; side by side there is room for two only, two by two for all.
TEST(SeparateClusters, FourThingsThatFitInOneWayOnlyFindIt) {
  const std::string things =
      ObjectText("a", "TERTIARY", "SURFACE", 0.2, 0.19) + ObjectText("b", "TERTIARY", "SURFACE", 0.19, 0.2) +
      ObjectText("c", "TERTIARY", "SURFACE", 0.2, 0.2) + ObjectText("d", "TERTIARY", "SURFACE", 0.18, 0.2);
  const std::string edges = OnTop("e1", "a") + OnTop("e2", "b") + OnTop("e3", "c") + OnTop("e4", "d");
  for (int seed : {0, 1, 2}) {
    const v1::SolvedLayout layout = Solve(Stool(0.41, things, edges), seed);
    EXPECT_LT(layout.metrics().oor_percent(), 1e-6) << seed;
    EXPECT_EQ(layout.diagnostics_size(), 0) << layout.ShortDebugString();
    const v1::Placement& stool = PlacementOf(layout, "stool");
    for (const char* id : {"a", "b", "c", "d"}) {
      EXPECT_LE(std::abs(PlacementOf(layout, id).x_m() - stool.x_m()), 0.205 - 0.09 + 1e-6) << id;
      EXPECT_LE(std::abs(PlacementOf(layout, id).y_m() - stool.y_m()), 0.205 - 0.09 + 1e-6) << id;
    }
  }
}

TEST(SeparateClusters, WhatHasNoRoomOnItsTopIsNamed) {
  const std::string things =
      ObjectText("a", "TERTIARY", "SURFACE", 0.3, 0.3) + ObjectText("b", "TERTIARY", "SURFACE", 0.3, 0.3);
  const v1::SolvedLayout layout = Solve(Stool(0.4, things, OnTop("e1", "a") + OnTop("e2", "b")), 0);
  ASSERT_EQ(layout.diagnostics_size(), 1);
  EXPECT_EQ(layout.diagnostics(0).code(), "does_not_fit");
  EXPECT_EQ(layout.diagnostics(0).subject_id(), "b");
  EXPECT_NE(layout.diagnostics(0).message().find("the a "), std::string::npos) << layout.diagnostics(0).message();
}

TEST(SeparateClusters, ABlanketLargerThanItsSeatLeavesTheCushionFree) {
  const std::string things =
      ObjectText("cushion", "TERTIARY", "SURFACE", 0.5, 0.5) + ObjectText("blanket", "TERTIARY", "SURFACE", 1.0, 1.5);
  for (int seed : {0, 1, 2}) {
    const v1::SolvedLayout layout = Solve(Stool(0.6, things, OnTop("e1", "cushion") + OnTop("e2", "blanket")), seed);
    EXPECT_LT(layout.metrics().oor_percent(), 1e-6) << seed;
    EXPECT_LT(layout.metrics().oob_percent(), 1e-6) << seed;
    // The cushion is on the seat.
    EXPECT_LE(std::abs(PlacementOf(layout, "cushion").x_m() - PlacementOf(layout, "stool").x_m()), 0.05 + 1e-6);
  }
}

TEST(SeparateClusters, AThinBlanketStaysUnderTheCushion) {
  const std::string things = ObjectText("cushion", "TERTIARY", "SURFACE", 0.5, 0.5) +
                             R"(objects { id: "blanket" name: "blanket" role: OBJECT_ROLE_TERTIARY
                                          kind: OBJECT_KIND_SURFACE zone_id: "sleeping"
                                          width_m: 1 depth_m: 1.5 height_m: 0.02 })";
  for (int seed : {0, 1, 2}) {
    const std::string pin = "pinned_placements { object_id: \"stool\" x_m: 2 y_m: 2 }";
    const v1::SolvedLayout layout =
        Solve(Stool(0.6, things, OnTop("e1", "cushion") + OnTop("e2", "blanket") + pin), seed);
    EXPECT_EQ(layout.metrics().findings_size(), 0) << layout.metrics().ShortDebugString();
  }
}

TEST(SeparateClusters, LampsUnderTheCeilingHangBesideEachOther) {
  std::string things, edges;
  for (const char* id : {"l1", "l2", "l3"}) {
    things += ObjectText(id, "TERTIARY", "CEILING", 0.6, 0.6);
    edges += EdgeText(id, "ceiling_above", Text("object", id) + Text("target", "stool"));
  }
  const v1::SolvedLayout layout = Solve(Stool(0.5, things, edges), 0);
  EXPECT_LT(layout.metrics().oor_percent(), 1e-6);
  EXPECT_LT(layout.metrics().oob_percent(), 1e-6);
  EXPECT_EQ(layout.diagnostics_size(), 0) << layout.ShortDebugString();
}

TEST(SeparateClusters, PinnedThingsStayAndOthersMakeWay) {
  const std::string things =
      ObjectText("a", "TERTIARY", "SURFACE", 0.2, 0.2) + ObjectText("b", "TERTIARY", "SURFACE", 0.2, 0.2);
  const std::string pins =
      "pinned_placements { object_id: \"stool\" x_m: 3 y_m: 3 } pinned_placements { object_id: \"a\" x_m: 3.05 y_m: 3 "
      "}";
  const v1::SolvedLayout layout = Solve(Stool(0.6, things, OnTop("e1", "a") + OnTop("e2", "b") + pins), 0);
  EXPECT_LT(layout.metrics().oor_percent(), 1e-6);
  EXPECT_EQ(PlacementOf(layout, "a").x_m(), 3.05);
  EXPECT_EQ(layout.diagnostics_size(), 0) << layout.ShortDebugString();
}

}  // namespace
}  // namespace flair::optimizer
