// SPDX-License-Identifier: GPL-3.0-or-later
// What heights mean for a whole solve, in a rectangle and in an L-shaped room.
#include <gtest/gtest.h>

#include <cmath>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/testing/graphs.h"

namespace flair::optimizer {
namespace {

struct Piece {
  const char* id;
  const char* kind;
  double width_m, depth_m, height_m;
  double elevation_m = 0;
};

std::string PieceText(const Piece& piece) {
  const bool on_wall = std::string(piece.kind) == "WALL";
  return fmt::format(R"(objects {{ id: "{0}" name: "{0}" role: OBJECT_ROLE_{1} kind: OBJECT_KIND_{2} zone_id: "all"
                                   width_m: {3} depth_m: {4} height_m: {5} elevation_m: {6} }})",
                     piece.id, on_wall ? "TERTIARY" : "PRIMARY", piece.kind, piece.width_m, piece.depth_m,
                     piece.height_m, piece.elevation_m);
}

// Door in the first wall, a window of 1.6 m with its sill at 0.9 m in the second; the other walls are plain.
std::string RoomOf(std::initializer_list<Vec2<double>> corners) {
  std::string vertices, walls;
  int wall = 0;
  for (const Vec2<double>& p : corners) {
    vertices += fmt::format("vertices {{ x_m: {} y_m: {} }} ", p.x, p.y);
    walls += fmt::format("walls {{ name: \"wall_{}\" }} ", ++wall);
  }
  return fmt::format(
      R"(room {{ room_type: "room" height_m: 3 floor {{ {} }} {}
           openings {{ id: "door_1" kind: OPENING_KIND_DOOR wall: "wall_1" offset_m: 0.1 width_m: 0.8 head_height_m: 2.1
                       leaf {{ hinge: HINGE_SIDE_START swing: DOOR_SWING_INWARD swing_angle_rad: 1.5707963 }} }}
           openings {{ id: "window_1" kind: OPENING_KIND_WINDOW wall: "wall_2" offset_m: 0.7 width_m: 1.6
                       sill_height_m: 0.9 head_height_m: 2.1 }} }}
         zone_plan {{ zones {{ id: "all" name: "all" }} }})",
      vertices, walls);
}

std::vector<std::string> Rooms() {
  return {RoomOf({{0, 0}, {4, 0}, {4, 3}, {0, 3}}), RoomOf({{0, 0}, {4, 0}, {4, 3}, {2.4, 3}, {2.4, 4.4}, {0, 4.4}})};
}

v1::SolvedLayout Solve(const std::string& room, std::initializer_list<Piece> pieces, const std::string& edges) {
  std::string objects = "object_list {";
  for (const Piece& piece : pieces) objects += PieceText(piece);
  const v1::LayoutGraph graph = Parse(room + objects + "}" + edges);
  absl::StatusOr<SolveResult> result = SolveLayout(graph, {}, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  if (!result.ok()) return {};
  EXPECT_EQ(result->layout.placements_size(), graph.object_list().objects_size());
  EXPECT_LT(result->layout.metrics().oor_percent(), 1e-6);
  EXPECT_LT(result->layout.metrics().oob_percent(), 1e-6);
  return std::move(result->layout);
}

bool Holds(const v1::SolvedLayout& layout, int edge) {
  return layout.edge_outcomes(edge).status() == v1::OUTCOME_STATUS_SATISFIED;
}

// Metres of the window (y from 0.7 to 2.3 on the wall at x = 4) with the piece within 0.45 m of it.
double InFrontOfWindow(const v1::SolvedLayout& layout, const Piece& piece) {
  const v1::Placement& at = PlacementOf(layout, piece.id);
  const double c = std::abs(std::cos(at.theta_rad())), s = std::abs(std::sin(at.theta_rad()));
  const double half_x = (c * piece.width_m + s * piece.depth_m) / 2;
  const double half_y = (s * piece.width_m + c * piece.depth_m) / 2;
  if (at.x_m() + half_x < 4 - 0.45) return 0;
  return std::max(0.0, std::min(at.y_m() + half_y, 2.3) - std::max(at.y_m() - half_y, 0.7));
}

std::string Clear(const char* id, const char* object) {
  return EdgeText(id, "clear_of_feature", Text("object", object) + Text("feature", "window"));
}

TEST(Heights, ATallPieceLeavesTheWindowFreeAndALowOneStandsUnderIt) {
  const Piece wardrobe{"wardrobe", "FLOOR", 1.2, 0.6, 2.0}, chest{"chest", "FLOOR", 1.2, 0.5, 0.8};
  const std::string edges = Clear("e1", "wardrobe") + EdgeText("e2", "against_wall", Text("object", "wardrobe")) +
                            Clear("e3", "chest") + EdgeText("e4", "under_window", Text("object", "chest")) +
                            EdgeText("e5", "against_wall", Text("object", "chest"));
  for (const std::string& room : Rooms()) {
    const v1::SolvedLayout layout = Solve(room, {wardrobe, chest}, edges);
    for (int e = 0; e < 5; ++e) EXPECT_TRUE(Holds(layout, e)) << layout.edge_outcomes(e).reason();
    EXPECT_LT(InFrontOfWindow(layout, wardrobe), 0.02);
    EXPECT_GT(InFrontOfWindow(layout, chest), 1.1);
  }
}

TEST(Heights, ATallPieceCannotStandUnderAWindowThatItMustNotBlock) {
  const std::string edges = Clear("e1", "wardrobe") + EdgeText("e2", "under_window", Text("object", "wardrobe"));
  for (const std::string& room : Rooms()) {
    const v1::SolvedLayout layout = Solve(room, {{"wardrobe", "FLOOR", 1.2, 0.6, 2.0}}, edges);
    EXPECT_FALSE(Holds(layout, 0) && Holds(layout, 1));
  }
}

TEST(Heights, CurtainsHangBeforeTheWindowAndADeskStandsBelow) {
  const Piece curtains{"curtains", "WALL", 1.6, 0.1, 1.5, 0.8}, desk{"desk", "FLOOR", 1.2, 0.6, 0.75};
  const std::string edges = EdgeText("e1", "under_window", Text("object", "curtains")) +
                            EdgeText("e2", "under_window", Text("object", "desk"));
  for (const std::string& room : Rooms()) {
    const v1::SolvedLayout layout = Solve(room, {desk, curtains}, edges);
    for (int e = 0; e < 2; ++e) EXPECT_TRUE(Holds(layout, e)) << layout.edge_outcomes(e).reason();
    EXPECT_EQ(layout.metrics().findings_size(), 0) << layout.metrics().ShortDebugString();
    EXPECT_GT(InFrontOfWindow(layout, curtains), 1.59);
  }
}

TEST(Heights, AWallLampHangsAboveTheBed) {
  const std::string edges = EdgeText("e1", "against_wall", Text("object", "bed")) +
                            EdgeText("e2", "on_wall_above", Text("object", "lamp") + Text("target", "bed"));
  for (const std::string& room : Rooms()) {
    const v1::SolvedLayout layout =
        Solve(room, {{"bed", "FLOOR", 1.4, 2.0, 0.9}, {"lamp", "WALL", 0.3, 0.15, 0.3, 1.4}}, edges);
    for (int e = 0; e < 2; ++e) EXPECT_TRUE(Holds(layout, e)) << layout.edge_outcomes(e).reason();
    // Over its head.
    const v1::Placement& bed = PlacementOf(layout, "bed");
    const v1::Placement& lamp = PlacementOf(layout, "lamp");
    EXPECT_LT(std::hypot(bed.x_m() - lamp.x_m(), bed.y_m() - lamp.y_m()), 1.0);
  }
}

TEST(Heights, APictureDoesNotHangBehindAWardrobeThatItWasAskedToHangAbove) {
  const std::string edges = EdgeText("e1", "against_wall", Text("object", "wardrobe")) +
                            EdgeText("e2", "on_wall_above", Text("object", "picture") + Text("target", "wardrobe"));
  for (const std::string& room : Rooms()) {
    const v1::SolvedLayout layout =
        Solve(room, {{"wardrobe", "FLOOR", 1.8, 0.6, 2.2}, {"picture", "WALL", 0.8, 0.05, 0.6, 1.4}}, edges);
    EXPECT_TRUE(Holds(layout, 0));
    EXPECT_FALSE(Holds(layout, 1));
    EXPECT_EQ(layout.diagnostics_size(), 0) << layout.diagnostics(0).message();
    // The same picture, hung above a sideboard or high up.
    EXPECT_TRUE(
        Holds(Solve(room, {{"wardrobe", "FLOOR", 1.8, 0.6, 0.9}, {"picture", "WALL", 0.8, 0.05, 0.6, 1.4}}, edges), 1));
    EXPECT_TRUE(
        Holds(Solve(room, {{"wardrobe", "FLOOR", 1.8, 0.6, 2.0}, {"picture", "WALL", 0.8, 0.05, 0.6, 2.1}}, edges), 1));
  }
}

// Wardrobes leave a gap on the wall opposite the door; the other walls are full.
std::string FullWalls(double gap_m) {
  const double w = (4 - gap_m) / 2;
  const auto pin = [](const char* id, double x_m, double y_m, double theta_rad) {
    return fmt::format("pinned_placements {{ object_id: \"{}\" x_m: {} y_m: {} theta_rad: {} }} ", id, x_m, y_m,
                       theta_rad);
  };
  constexpr double kHalfTurn = 3.14159265358979;
  return pin("w1", w / 2, 2.7, kHalfTurn) + pin("w2", 4 - w / 2, 2.7, kHalfTurn) +
         pin("w3", 0.3, 1.65, 1.5 * kHalfTurn) + pin("w4", 2.5, 0.3, 0);
}

v1::SolvedLayout AmongWardrobes(double gap_m, double picture_m) {
  const double w = (4 - gap_m) / 2;
  const std::string room = Rooms()[0];
  const v1::LayoutGraph graph =
      Parse(room + "object_list {" + PieceText({"w1", "FLOOR", w, 0.6, 2.0}) + PieceText({"w2", "FLOOR", w, 0.6, 2.0}) +
            PieceText({"w3", "FLOOR", 1.4, 0.6, 2.0}) + PieceText({"w4", "FLOOR", 3.0, 0.6, 2.0}) +
            PieceText({"picture", "WALL", picture_m, 0.05, 0.6, 1.4}) + "}" + FullWalls(gap_m) +
            EdgeText("e1", "on_wall_above", Text("object", "picture") + Text("target", "w1")));
  absl::StatusOr<SolveResult> result = SolveLayout(graph, {}, NloptSolver());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? std::move(result->layout) : v1::SolvedLayout();
}

TEST(Heights, TheOnlyFreeStretchOfWallIsFound) {
  const v1::SolvedLayout layout = AmongWardrobes(0.81, 0.8);
  EXPECT_LT(layout.metrics().oor_percent(), 1e-6);
  EXPECT_EQ(layout.diagnostics_size(), 0) << layout.diagnostics(0).message();
  EXPECT_NEAR(PlacementOf(layout, "picture").x_m(), 2.0, 0.006);
  EXPECT_NEAR(PlacementOf(layout, "picture").y_m(), 3 - 0.025, 1e-6);
}

// What belongs to a shelf and is asked to lie like something on a table that is turned the other way.
TEST(Heights, ThingsTurnSoThatTheyDoNotHangOver) {
  const v1::LayoutGraph graph =
      Parse(Rooms()[0] + "object_list {" + PieceText({"shelf", "FLOOR", 0.8, 0.3, 0.9}) +
            PieceText({"table", "FLOOR", 1.2, 0.6, 0.75}) +
            R"(objects { id: "books" name: "books" role: OBJECT_ROLE_TERTIARY kind: OBJECT_KIND_SURFACE zone_id: "all"
                   host_id: "shelf" width_m: 0.5 depth_m: 0.25 height_m: 0.2 } }
         pinned_placements { object_id: "shelf" x_m: 2 y_m: 0.15 theta_rad: 0 }
         pinned_placements { object_id: "table" x_m: 0.3 y_m: 1.8 theta_rad: 4.71238898 })" +
            EdgeText("e1", "on_top_center", Text("object", "books") + Text("host", "table")));
  absl::StatusOr<SolveResult> result = SolveLayout(graph, {}, NloptSolver());
  ASSERT_TRUE(result.ok()) << result.status();
  const v1::LayoutMetrics& metrics = result->layout.metrics();
  EXPECT_EQ(metrics.unsupported_count(), 0) << metrics.ShortDebugString();
  EXPECT_EQ(metrics.oor_3d_percent(), 0);
}

// The door's leaf comes to stand 0.1 m before the wall at x = 0, up to y = 0.8: the middle above the board is no place.
TEST(Heights, NothingHangsWhereADoorsLeafComesTo) {
  for (const std::string& room : Rooms()) {
    const v1::LayoutGraph graph =
        Parse(room + "object_list {" + PieceText({"board", "FLOOR", 0.5, 0.1, 0.5}) +
              PieceText({"shelf", "WALL", 0.6, 0.2, 0.3, 1.5}) + "}" +
              "pinned_placements { object_id: \"board\" x_m: 0.05 y_m: 0.9 theta_rad: 4.71238898 }" +
              EdgeText("e1", "on_wall_above", Text("object", "shelf") + Text("target", "board")));
    absl::StatusOr<SolveResult> result = SolveLayout(graph, {}, NloptSolver());
    ASSERT_TRUE(result.ok()) << result.status();
    EXPECT_EQ(result->layout.metrics().findings_size(), 0) << result->layout.metrics().ShortDebugString();
  }
}

TEST(Heights, APictureWithoutAnyFreeStretchIsNamed) {
  const v1::SolvedLayout layout = AmongWardrobes(0.9, 1.0);
  ASSERT_EQ(layout.diagnostics_size(), 1) << PlacementOf(layout, "picture").ShortDebugString();
  EXPECT_EQ(layout.diagnostics(0).code(), "does_not_fit");
  EXPECT_EQ(layout.diagnostics(0).subject_id(), "picture");
}

}  // namespace
}  // namespace flair::optimizer
