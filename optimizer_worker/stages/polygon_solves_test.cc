// SPDX-License-Identifier: GPL-3.0-or-later
// Whole solves in rooms that are not rectangles.
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"
#include "room/geometry/polygon.h"

namespace flair::optimizer {
namespace {

struct Shape {
  const char* name;
  Polygon floor;
};

std::vector<Shape> Shapes() {
  return {{"L", {{{0, 0}, {5, 0}, {5, 2.6}, {2.6, 2.6}, {2.6, 5}, {0, 5}}}},
          {"mirrored L", {{{0, 0}, {5, 0}, {5, 5}, {2.4, 5}, {2.4, 2.4}, {0, 2.4}}}},
          {"T", {{{1.5, 0}, {4, 0}, {4, 2.6}, {5.5, 2.6}, {5.5, 5}, {0, 5}, {0, 2.6}, {1.5, 2.6}}}},
          {"U", {{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2.2}, {2, 2.2}, {2, 4}, {0, 4}}}}};
}

std::string RoomOf(const Polygon& floor) {
  std::string vertices, walls;
  for (size_t i = 0; i < floor.vertices.size(); ++i) {
    vertices += fmt::format("vertices {{ x_m: {} y_m: {} }} ", floor.vertices[i].x, floor.vertices[i].y);
    walls += fmt::format("walls {{ name: \"wall_{}\" }} ", i + 1);
  }
  return fmt::format(
      R"(room {{ room_type: "studio" height_m: 3 floor {{ {} }} {}
           openings {{ id: "door_1" kind: OPENING_KIND_DOOR wall: "wall_1" offset_m: 0.2 width_m: 0.8 head_height_m: 2.1
                       leaf {{ hinge: HINGE_SIDE_START swing: DOOR_SWING_INWARD swing_angle_rad: 1.5707963 }} }}
           openings {{ id: "window_1" kind: OPENING_KIND_WINDOW wall: "wall_2" offset_m: 0.6 width_m: 1.2
                       sill_height_m: 0.9 head_height_m: 2.1 }} }}
         zone_plan {{ zones {{ id: "sleeping" name: "sleeping" }} zones {{ id: "sitting" name: "sitting" }} }})",
      vertices, walls);
}

std::string ObjectIn(const char* zone, const char* id, const char* role, const char* kind, double width_m,
                     double depth_m, double height_m, const char* more = "") {
  return fmt::format(R"(objects {{ id: "{0}" name: "{0}" role: OBJECT_ROLE_{1} kind: OBJECT_KIND_{2} zone_id: "{3}"
                                   width_m: {4} depth_m: {5} height_m: {6} {7} }})",
                     id, role, kind, zone, width_m, depth_m, height_m, more);
}

v1::LayoutGraph Studio(const Polygon& floor) {
  const std::string objects = ObjectIn("sleeping", "bed", "PRIMARY", "FLOOR", 1.4, 2.0, 0.6) +
                              ObjectIn("sitting", "sofa", "PRIMARY", "FLOOR", 1.8, 0.8, 0.8) +
                              ObjectIn("sleeping", "nightstand", "SECONDARY", "FLOOR", 0.45, 0.4, 0.5) +
                              ObjectIn("sleeping", "wardrobe", "SECONDARY", "FLOOR", 1.2, 0.6, 2.0) +
                              ObjectIn("sitting", "coffee_table", "SECONDARY", "FLOOR", 0.9, 0.5, 0.45) +
                              ObjectIn("sitting", "rug", "TERTIARY", "FLOOR", 1.8, 1.4, 0.01, "walk_over: true") +
                              ObjectIn("sitting", "picture", "TERTIARY", "WALL", 0.8, 0.05, 0.6, "elevation_m: 1.4") +
                              ObjectIn("sleeping", "mirror", "TERTIARY", "WALL", 0.5, 0.05, 1.2, "elevation_m: 0.7") +
                              ObjectIn("sleeping", "lamp", "TERTIARY", "SURFACE", 0.2, 0.2, 0.4) +
                              ObjectIn("sitting", "pendant", "TERTIARY", "CEILING", 0.5, 0.5, 0.4, "elevation_m: 2.4");
  const std::string edges = EdgeText("e1", "against_wall", Text("object", "bed")) +
                            EdgeText("e2", "against_wall", Text("object", "sofa")) +
                            EdgeText("e3", "next_to", Text("object", "nightstand") + Text("target", "bed")) +
                            EdgeText("e4", "against_wall", Text("object", "wardrobe")) +
                            EdgeText("e5", "in_front_of", Text("object", "coffee_table") + Text("target", "sofa")) +
                            EdgeText("e6", "rug_under_center", Text("rug", "rug") + Text("object", "coffee_table")) +
                            EdgeText("e7", "on_wall_above", Text("object", "picture") + Text("target", "sofa")) +
                            EdgeText("e8", "on_wall_near", Text("object", "mirror") + Text("target", "wardrobe")) +
                            EdgeText("e9", "on_top_center", Text("object", "lamp") + Text("host", "nightstand")) +
                            EdgeText("e10", "ceiling_center", Text("object", "pendant"));
  return Parse(RoomOf(floor) + "object_list {" + objects + "}" + edges);
}

void ExpectExact(const v1::SolvedLayout& layout) {
  EXPECT_EQ(layout.placements_size(), layout.graph().object_list().objects_size());
  EXPECT_LT(layout.metrics().oob_percent(), 1e-6);
  EXPECT_LT(layout.metrics().oor_percent(), 1e-6);
  EXPECT_LT(layout.metrics().deepest_overlap_m(), 1e-6);
  EXPECT_GT(layout.metrics().reachable_floor_share(), 0.9);
  for (const v1::Diagnostic& diagnostic : layout.diagnostics()) ADD_FAILURE() << diagnostic.message();
}

void ExpectZonesToCover(const v1::SolvedLayout& layout, const Polygon& floor) {
  double area_m2 = 0;
  for (const v1::ZoneRegion& region : layout.zone_regions()) {
    for (const v1::Polygon& part : region.parts()) {
      Polygon polygon;
      for (const v1::Point2& p : part.vertices()) polygon.vertices.push_back({p.x_m(), p.y_m()});
      for (const Vec2<double>& p : polygon.vertices) EXPECT_GT(SignedDistance(floor, p), -1e-9);
      EXPECT_GT(SignedArea(polygon.vertices), 0);
      area_m2 += Area(polygon);
    }
  }
  EXPECT_EQ(layout.zone_regions_size(), 2);
  EXPECT_NEAR(area_m2, Area(floor), 1e-9);
}

// Each edge asked about by itself says what the solve says.
void ExpectVerdictsToAgree(const v1::SolvedLayout& layout) {
  v1::EvaluateRequest request;
  *request.mutable_layout_graph() = layout.graph();
  *request.mutable_placements() = layout.placements();
  const auto again = EvaluateLayout(request, NloptSolver());
  ASSERT_TRUE(again.ok()) << again.status();
  ASSERT_EQ(again->edge_outcomes_size(), layout.edge_outcomes_size());
  for (int e = 0; e < layout.edge_outcomes_size(); ++e) {
    EXPECT_NE(layout.edge_outcomes(e).status(), v1::OUTCOME_STATUS_DROPPED) << layout.edge_outcomes(e).reason();
    EXPECT_EQ(again->edge_outcomes(e).status(), layout.edge_outcomes(e).status()) << layout.edge_outcomes(e).reason();
    EXPECT_EQ(again->edge_outcomes(e).cost(), layout.edge_outcomes(e).cost());
  }
}

TEST(PolygonSolves, EndExactInRoomsOfManyShapes) {
  for (const Shape& shape : Shapes()) {
    const v1::LayoutGraph graph = Studio(shape.floor);
    for (int seed : {0, 1}) {
      SCOPED_TRACE(fmt::format("{}, seed {}", shape.name, seed));
      v1::SolveOptions options;
      options.set_seed(seed);
      const absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver());
      ASSERT_TRUE(result.ok()) << result.status();
      ExpectExact(result->layout);
      ExpectZonesToCover(result->layout, shape.floor);
      ExpectVerdictsToAgree(result->layout);
      int held = 0;
      for (const v1::EdgeOutcome& outcome : result->layout.edge_outcomes()) {
        held += outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
      }
      EXPECT_GE(held, 9);
    }
  }
}

}  // namespace
}  // namespace flair::optimizer
