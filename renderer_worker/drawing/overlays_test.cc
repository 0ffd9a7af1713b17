// SPDX-License-Identifier: GPL-3.0-or-later
// What the overlays show: verdicts of constraints, ways, and free distances.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/layers.h"
#include "renderer_worker/drawing/testing/read_drawing.h"

namespace flair::renderer {
namespace {

using testing::ElementsAre;

Plan Nursery(const PlanLayers& layers) {
  absl::StatusOr<Plan> plan = ReadPlan(ReadSample("nursery"), layers);
  EXPECT_TRUE(plan.ok()) << plan.status();
  return *std::move(plan);
}

const PlanEdge& EdgeSaying(const Plan& plan, const std::string& words) {
  const auto at = std::find_if(plan.edges.begin(), plan.edges.end(),
                               [&words](const PlanEdge& edge) { return edge.words == words; });
  if (at == plan.edges.end()) std::abort();
  return *at;
}

bool Near(Point p, double x, double y) { return std::hypot(p.x - x, p.y - y) < 1e-9; }

TEST(Overlays, AreReadOnlyWhenTheirLayerIsDrawn) {
  const Plan plan = Nursery({});
  EXPECT_TRUE(plan.edges.empty());
  EXPECT_TRUE(plan.routes_m.empty());
}

TEST(Overlays, EdgesJoinObjectsWallsZonesAndFeatures) {
  const Plan plan = Nursery({.constraints = true});
  ASSERT_EQ(plan.edges.size(), 11u);
  // No wall is named: the nearest.
  const PlanEdge& wall = EdgeSaying(plan, "Both cots stand against a wall.");
  ASSERT_EQ(wall.operands_m.size(), 2u);
  EXPECT_TRUE(Near(wall.operands_m[0], 0.36, 2.7) && Near(wall.operands_m[1], 0, 2.7));
  const PlanEdge& named = EdgeSaying(plan, "The bookshelf stands at the east wall.");
  EXPECT_TRUE(Near(named.operands_m.at(1), 4, 1.85));
  const PlanEdge& pair = EdgeSaying(plan, "The dresser is close to the cots.");
  EXPECT_TRUE(Near(pair.operands_m.at(0), 2.2, 3.15) && Near(pair.operands_m.at(1), 0.36, 2.7));
  EXPECT_EQ(pair.status, v1::OUTCOME_STATUS_VIOLATED);
  EXPECT_EQ(pair.miss, "0.35 m");
  EXPECT_EQ(EdgeSaying(plan, "The rocking chair faces the cots.").miss, "24°");
  const PlanEdge& zone = EdgeSaying(plan, "The rug lies in the middle of the play area.");
  EXPECT_TRUE(Near(zone.operands_m.at(1), 2.8, 1.4));
  const PlanEdge& door = EdgeSaying(plan, "The toy chest is away from the door.");
  EXPECT_TRUE(Near(door.operands_m.at(1), 3.15, 0));
  const PlanEdge& socket = EdgeSaying(plan, "The lamp is plugged into a socket.");
  EXPECT_EQ(socket.status, v1::OUTCOME_STATUS_DROPPED);
  EXPECT_TRUE(Near(socket.operands_m.at(1), 4, 2.2));  // the nearer of two
}

TEST(Overlays, EdgesOfStrangeCallsDoNoHarm) {
  v1::SolvedLayout layout = ReadSample("nursery");
  layout.mutable_graph()->mutable_edges(0)->clear_arguments();
  layout.mutable_graph()->mutable_edges(1)->mutable_arguments(0)->mutable_value()->set_text("nobody");
  layout.mutable_graph()->mutable_edges(2)->set_sentence_id("s999");
  layout.mutable_edge_outcomes(2)->set_missed_by(std::nan(""));
  layout.mutable_edge_outcomes(3)->set_edge_id("e999");
  const absl::StatusOr<Plan> plan = ReadPlan(layout, {.constraints = true});
  ASSERT_TRUE(plan.ok());
  ASSERT_EQ(plan->edges.size(), 10u);
  EXPECT_TRUE(plan->edges[0].operands_m.empty());
  EXPECT_TRUE(plan->edges[1].operands_m.empty());
  EXPECT_EQ(plan->edges[2].words, "near dresser 1 cot 1");
  EXPECT_EQ(plan->edges[2].miss, "");
  v1::RenderOptions options;
  options.set_size_px(400);
  options.add_layers(v1::PLAN_LAYER_CONSTRAINTS);
  EXPECT_TRUE(DrawPlan(layout, options).ok());
}

TEST(Overlays, WaysLeadFromTheDoorAndNameWhatTheyDoNotReach) {
  const Plan plan = Nursery({.circulation = true});
  EXPECT_THAT(plan.blocked, ElementsAre("laundry basket"));
  ASSERT_EQ(plan.routes_m.size(), 7u);
  for (const std::vector<Point>& route : plan.routes_m) {
    EXPECT_TRUE(Near(route.front(), 3.15, 0));
    for (size_t i = 1; i < route.size(); ++i) EXPECT_TRUE(PolygonContains(plan.floor, route[i]));
  }
  for (const PlanObject& object : plan.objects) EXPECT_EQ(object.blocked, object.id == "laundry_basket_1") << object.id;
}

// Pixels that look like the colour, of a drawing with these layers.
int PixelsLike(const Rgb& colour, const std::vector<v1::PlanLayer>& layers) {
  v1::RenderOptions options;
  options.set_size_px(3200);  // lines wide enough to have a middle
  for (v1::PlanLayer layer : layers) options.add_layers(layer);
  const absl::StatusOr<DrawnPlan> drawn = DrawPlan(ReadSample("nursery"), options);
  EXPECT_TRUE(drawn.ok());
  int count = 0;
  for (size_t i = 0; i < drawn->pixels.rgb.size(); i += 3) {
    const uint8_t* rgb = &drawn->pixels.rgb[i];
    count += std::abs(rgb[0] - 255 * colour.red) + std::abs(rgb[1] - 255 * colour.green) +
                 std::abs(rgb[2] - 255 * colour.blue) <
             12;
  }
  return count;
}

TEST(Overlays, VerdictsAreDrawnInTheirColours) {
  for (const auto verdict : {v1::OUTCOME_STATUS_SATISFIED, v1::OUTCOME_STATUS_VIOLATED}) {
    const Rgb colour = VerdictStroke(verdict).colour;
    EXPECT_EQ(PixelsLike(colour, {v1::PLAN_LAYER_ZONES}), 0);
    EXPECT_GT(PixelsLike(colour, {v1::PLAN_LAYER_ZONES, v1::PLAN_LAYER_CONSTRAINTS}), 1000);
  }
}

TEST(Overlays, ViolationsAreLetteredLikeColumnsOfATable) {
  EXPECT_EQ(ViolationLetters(0), "A");
  EXPECT_EQ(ViolationLetters(25), "Z");
  EXPECT_EQ(ViolationLetters(26), "AA");
  EXPECT_EQ(ViolationLetters(701), "ZZ");
  EXPECT_EQ(ViolationLetters(702), "AAA");
}

Plan RoomWith(const std::vector<PlanObject>& objects) {
  Plan plan;
  plan.floor = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  plan.objects = objects;
  return plan;
}

PlanObject Piece(double x, double y, double theta, double width, double depth) {
  PlanObject piece;
  piece.centre_m = {x, y};
  piece.theta_rad = theta;
  piece.width_m = width;
  piece.depth_m = depth;
  return piece;
}

TEST(Clearances, RunFromALargeFrontToTheNextPieceOrWall) {
  const std::vector<Clearance> free = FindClearances(RoomWith({Piece(2, 1, 0, 1.6, 0.8)}));
  ASSERT_EQ(free.size(), 1u);
  EXPECT_TRUE(Near(free[0].from_m, 2, 1.4) && Near(free[0].to_m, 2, 3));
  EXPECT_NEAR(free[0].length_m, 1.6, 1e-9);
  const std::vector<Clearance> met = FindClearances(RoomWith({Piece(2, 1, 0, 1.6, 0.8), Piece(2, 2.5, 0, 0.4, 0.4)}));
  ASSERT_EQ(met.size(), 1u);
  EXPECT_NEAR(met[0].length_m, 0.9, 1e-9);
}

TEST(Clearances, AreLeftOutWhereTheySayNothingNew) {
  // Two that look at each other, one that touches the wall, a small one, a rug.
  const PlanObject facing = Piece(2, 2.6, std::acos(-1.0), 1.6, 0.8);
  EXPECT_EQ(FindClearances(RoomWith({Piece(2, 0.4, 0, 1.6, 0.8), facing})).size(), 1u);
  EXPECT_TRUE(FindClearances(RoomWith({Piece(2, 2.6, 0, 1.6, 0.8)})).empty());
  EXPECT_TRUE(FindClearances(RoomWith({Piece(2, 1, 0, 0.5, 0.5)})).empty());
  PlanObject rug = Piece(2, 1, 0, 1.6, 1.2);
  rug.walk_over = true;
  EXPECT_TRUE(FindClearances(RoomWith({rug})).empty());
}

}  // namespace
}  // namespace flair::renderer
