// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/pattern_slots.h"
#include "optimizer_worker/stages/patterns.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "optimizer_worker/stages/stage.h"
#include "optimizer_worker/stages/testing/graphs.h"
#include "room/conversion/conversion.h"

namespace flair::optimizer {
namespace {

std::string Surround(int table, int first_chair, int chairs) {
  std::string items;
  for (int c = 0; c < chairs; ++c) items += fmt::format("items: \"chair_{}\" ", first_chair + c);
  return EdgeText(fmt::format("e{}", table).c_str(), "surround",
                  Text("center", fmt::format("table_{}", table).c_str()) +
                      fmt::format(R"(arguments {{ name: "objects" value {{ texts {{ {} }} }} }})", items));
}

// Tables, each with four chairs round it, and a cupboard at the wall.
v1::LayoutGraph Cafe(int tables, double side_m) {
  std::string objects, edges;
  for (int t = 0; t < tables; ++t) {
    objects += ObjectText(fmt::format("table_{}", t).c_str(), "PRIMARY", "FLOOR", 0.8, 0.8);
    edges += Surround(t, 4 * t, 4);
  }
  for (int c = 0; c < 4 * tables; ++c) {
    objects += ObjectText(fmt::format("chair_{}", c).c_str(), "SECONDARY", "FLOOR", 0.45, 0.45);
  }
  objects += ObjectText("cupboard", "SECONDARY", "FLOOR", 1.2, 0.4);
  return Parse(RoomText(side_m, side_m) + "object_list {" + objects + "}" + edges +
               EdgeText("wall", "against_wall", Text("object", "cupboard")));
}

SolveInput InputOf(const v1::LayoutGraph& graph, const Solver& solver) {
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, {}, solver, nullptr);
  EXPECT_TRUE(input.ok()) << input.status();
  input->groups = FindGroups(*input);
  return *std::move(input);
}

v1::SolvedLayout Solve(const v1::LayoutGraph& graph, int seed, v1::GroupPolicy policy, int threads = 1) {
  v1::SolveOptions options;
  options.set_seed(seed);
  options.set_groups(policy);
  options.set_thread_count(threads);
  const absl::StatusOr<SolveResult> result = SolveLayout(graph, options, NloptSolver(), nullptr, LocalRestartRunner());
  EXPECT_TRUE(result.ok()) << result.status();
  return result.ok() ? result->layout : v1::SolvedLayout();
}

std::set<std::string> StagesOf(const v1::SolvedLayout& layout) {
  std::set<std::string> stages;
  for (const v1::StageOutcome& outcome : layout.stage_outcomes()) stages.insert(outcome.stage());
  return stages;
}

TEST(FindGroups, ChairsBelongToTheirTableAndTablesThatAreAlikeMakeAPattern) {
  const NloptSolver solver;
  const v1::LayoutGraph graph = Cafe(5, 9);
  const SolveInput input = InputOf(graph, solver);
  ASSERT_EQ(input.groups.patterns.size(), 1u);
  EXPECT_EQ(input.groups.patterns[0].size(), 5u);
  const Group& group = input.groups.all[input.groups.patterns[0][0]];
  EXPECT_EQ(group.objects.size(), 5u);
  EXPECT_EQ(input.scene.objects[group.objects[0]].id, "table_0");
  EXPECT_EQ(input.groups.LeaderOf(input.scene, input.scene.IndexOf("chair_3")), group.objects[0]);
  EXPECT_EQ(input.groups.all[input.groups.of[input.scene.IndexOf("cupboard")]].objects.size(), 1u);
}

TEST(FindGroups, WhatIsPinnedJoinsNone) {
  const NloptSolver solver;
  v1::LayoutGraph graph = Cafe(1, 5);
  v1::Placement& pin = *graph.add_pinned_placements();
  pin.set_object_id("chair_0");
  pin.set_x_m(2.5);
  pin.set_y_m(4);
  const SolveInput input = InputOf(graph, solver);
  EXPECT_EQ(input.groups.of[input.scene.IndexOf("chair_0")], -1);
  EXPECT_EQ(input.groups.all[0].objects.size(), 4u);
}

TEST(ArrangeGroup, HoldsItsCallsAndNothingOverlaps) {
  const NloptSolver solver;
  const v1::LayoutGraph graph = Cafe(1, 5);
  const SolveInput input = InputOf(graph, solver);
  const Group& group = input.groups.all[0];
  ASSERT_FALSE(group.arrangements.empty());
  std::vector<Pose<double>> poses;
  PoseGroup(group.arrangements[0], {2.5, 2.5, 0}, poses);
  PartialLayout state(input.scene);
  for (size_t k = 0; k < poses.size(); ++k) state.Place(group.objects[k], poses[k]);
  EXPECT_TRUE(FindViolations(input.scene, input.keep_out, group.objects, state.layout, 1e-6).empty());
  const SceneCosts costs = BindCosts(input, state);
  const Term& surround = costs.terms[0];
  std::vector<Pose<double>> read;
  for (int object : surround.cost->objects()) read.push_back(state.layout[object]);
  EXPECT_LT(surround.cost->Value(read), 1e-4);
}

TEST(Groups, StayTogetherSquareAndInLineForEverySeed) {
  const v1::LayoutGraph graph = Cafe(6, 9);
  const absl::StatusOr<Scene> scene = SceneFromProto(graph);
  ASSERT_TRUE(scene.ok()) << scene.status();
  for (int seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const v1::SolvedLayout layout = Solve(graph, seed, v1::GROUP_POLICY_UNSPECIFIED);
    EXPECT_EQ(layout.diagnostics_size(), 0) << layout.diagnostics(0).ShortDebugString();
    for (const v1::Placement& p : layout.placements()) {
      EXPECT_LT(std::abs(std::sin(2 * p.theta_rad())), 1e-3) << p.object_id();
    }
    for (int t = 0; t < 6; ++t) {
      const v1::Placement& table = PlacementOf(layout, fmt::format("table_{}", t));
      for (int c = 4 * t; c < 4 * t + 4; ++c) {
        const v1::Placement& chair = PlacementOf(layout, fmt::format("chair_{}", c));
        EXPECT_LT(std::hypot(chair.x_m() - table.x_m(), chair.y_m() - table.y_m()), 0.4 + 0.225 + 0.1 + 0.1);
      }
      int in_line = 0;
      for (int other = 0; other < 6; ++other) {
        const v1::Placement& next = PlacementOf(layout, fmt::format("table_{}", other));
        in_line +=
            other != t && (std::abs(next.x_m() - table.x_m()) < 1e-3 || std::abs(next.y_m() - table.y_m()) < 1e-3);
      }
      EXPECT_GT(in_line, 0) << table.object_id();
    }
  }
}

TEST(Groups, OffGivesThePapersOrder) {
  const v1::LayoutGraph graph = Cafe(1, 5);
  EXPECT_TRUE(StagesOf(Solve(graph, 0, v1::GROUP_POLICY_OFF)).contains("secondary"));
  const NloptSolver solver;
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, {}, solver, nullptr);
  ASSERT_TRUE(input.ok()) << input.status();
  const std::vector<int> table = {0};
  EXPECT_EQ(FreeStage(*input, StageKind::kPrimary).objects, table);
  input->groups = FindGroups(*input);
  EXPECT_EQ(FreeStage(*input, StageKind::kPrimary).objects.size(), 5u);
}

TEST(Groups, GiveTheSameBytesOnAnyNumberOfThreads) {
  const v1::LayoutGraph graph = Cafe(4, 7);
  EXPECT_EQ(Solve(graph, 3, v1::GROUP_POLICY_ON, 1).SerializeAsString(),
            Solve(graph, 3, v1::GROUP_POLICY_ON, 3).SerializeAsString());
}

// Two rows of three desks that face a teacher's desk; the first row is nearer to it.
v1::LayoutGraph Class() {
  std::string objects = ObjectText("teacher", "PRIMARY", "FLOOR", 1.4, 0.7), edges;
  for (int d = 0; d < 6; ++d) objects += ObjectText(fmt::format("desk_{}", d).c_str(), "PRIMARY", "FLOOR", 0.7, 0.5);
  for (int d : {1, 2, 4, 5}) {
    edges += EdgeText(fmt::format("beside_{}", d).c_str(), "next_to",
                      Text("object", fmt::format("desk_{}", d).c_str()) +
                          Text("target", fmt::format("desk_{}", d - 1).c_str()) + Text("object_side", "left") +
                          Text("target_side", "right"));
  }
  const auto ahead = [](const char* id, const char* object, const char* target, double distance_m) {
    return EdgeText(id, "in_front_of",
                    Text("object", object) + Text("target", target) +
                        fmt::format(R"(arguments {{ name: "distance_m" value {{ number: {} }} }})", distance_m));
  };
  edges += ahead("rows", "desk_1", "desk_4", 0.9) + ahead("teaches", "teacher", "desk_1", 2) +
           EdgeText("looks", "facing", Text("object", "desk_1") + Text("target", "teacher"));
  return Parse(RoomText(7, 8) + "object_list {" + objects + "}" + edges);
}

TEST(Groups, RowsBeginAtTheDeskThatTheyFaceForEverySeed) {
  for (int seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    const v1::SolvedLayout layout = Solve(Class(), seed, v1::GROUP_POLICY_UNSPECIFIED);
    for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
      EXPECT_LT(outcome.cost(), 0.01) << outcome.ShortDebugString();
    }
  }
}

TEST(Groups, IslandsAreGroupsOfAPattern) {
  // Two islands of four, back to back and side by side, and one of two.
  std::string objects, edges;
  for (int d = 0; d < 10; ++d) objects += ObjectText(fmt::format("desk_{}", d).c_str(), "PRIMARY", "FLOOR", 1.2, 0.6);
  const auto beside = [&](int object, int target, const char* side, const char* other) {
    edges += EdgeText(fmt::format("beside_{}", object).c_str(), "next_to",
                      Text("object", fmt::format("desk_{}", object).c_str()) +
                          Text("target", fmt::format("desk_{}", target).c_str()) + Text("object_side", side) +
                          Text("target_side", other));
  };
  for (int first : {0, 4}) {
    beside(first + 1, first, "back", "back");
    beside(first + 2, first, "left", "right");
    beside(first + 3, first + 2, "back", "back");
  }
  beside(9, 8, "back", "back");
  const v1::LayoutGraph graph = Parse(RoomText(9, 7) + "object_list {" + objects + "}" + edges);
  const NloptSolver solver;
  absl::StatusOr<SolveInput> input = MakeSolveInput(graph, {}, solver, nullptr);
  ASSERT_TRUE(input.ok()) << input.status();
  const Groups groups = FindGroups(*input);
  ASSERT_EQ(groups.patterns.size(), 1u);
  EXPECT_EQ(groups.patterns[0].size(), 3u) << "the last island has two desks";
  for (int g : groups.patterns[0]) EXPECT_TRUE(groups.all[g].block);
  const v1::SolvedLayout layout = Solve(graph, 0, v1::GROUP_POLICY_UNSPECIFIED);
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    EXPECT_LT(outcome.cost(), 0.01) << outcome.ShortDebugString();
  }
}

TEST(Groups, ARowKeepsTogetherThoughTheChairsBeforeItAreLarger) {
  std::string objects, edges, items;
  for (int s = 0; s < 4; ++s) {
    const std::string station = fmt::format("station_{}", s), chair = fmt::format("chair_{}", s);
    objects += ObjectText(station.c_str(), "PRIMARY", "FLOOR", 1.2, 0.35);
    objects += ObjectText(chair.c_str(), "SECONDARY", "FLOOR", 0.65, 0.7);
    edges += EdgeText(("wall_" + station).c_str(), "against_wall", Text("object", station.c_str()));
    edges += EdgeText(("seat_" + station).c_str(), "next_to",
                      Text("object", chair.c_str()) + Text("target", station.c_str()) + Text("object_side", "front") +
                          Text("target_side", "front"));
    items += fmt::format(R"(items: "{}" )", station);
  }
  edges += EdgeText("row", "row", fmt::format(R"(arguments {{ name: "objects" value {{ texts {{ {} }} }} }})", items));
  const v1::LayoutGraph graph = Parse(RoomText(7, 5) + "object_list {" + objects + "}" + edges);
  for (int seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE(seed);
    const v1::SolvedLayout layout = Solve(graph, seed, v1::GROUP_POLICY_UNSPECIFIED);
    for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
      EXPECT_LT(outcome.cost(), 0.01) << outcome.ShortDebugString();
    }
  }
}

TEST(WalkPenalty, ADeskDoesNotBlockTheFrontOfItsChair) {
  const NloptSolver solver;
  const v1::LayoutGraph graph = Cafe(1, 5);
  const SolveInput input = InputOf(graph, solver);
  PartialLayout state(input.scene);
  std::vector<Pose<double>> poses;
  PoseGroup(input.groups.all[0].arrangements[0], {2.5, 2.5, 0}, poses);
  for (size_t k = 0; k < poses.size(); ++k) state.Place(input.groups.all[0].objects[k], poses[k]);
  const SceneCosts costs = BindCosts(input, state);
  SearchInput search_input = SearchInputOf(input, {}, &input.walk_grid.get());
  const auto penalty = [&] {
    const StageSpec stage = MakeStage(input.scene, StageKind::kPolish);
    return LayoutSearch(search_input, MakeProblem(input, costs, stage, state), state.layout).WalkPenalty();
  };
  const double belonging = penalty();
  // Four chairs before the table, and the table before one of them.
  search_input.linked = nullptr;
  EXPECT_NEAR(penalty() - belonging, 5 * search_input.walk_weights.blocked_front, 1e-9);
}

TEST(DisorderOf, ChargesThoseThatDoNotLookAlongTheAxisOfMost) {
  std::string objects;
  for (int b = 0; b < 5; ++b) objects += ObjectText(fmt::format("bed_{}", b).c_str(), "PRIMARY", "FLOOR", 0.9, 2);
  const NloptSolver solver;
  const v1::LayoutGraph graph = Parse(RoomText(7, 8) + "object_list {" + objects + "}");
  const SolveInput input = InputOf(graph, solver);
  PartialLayout state(input.scene);
  for (int b = 0; b < 3; ++b) state.Place(b, {1, 2.0 + 1.5 * b, -kPi / 2});
  state.Place(3, {6, 2, kPi / 2});
  state.Place(4, {6, 5, kPi / 2});
  EXPECT_EQ(DisorderOf(input, state), 0);
  state.Place(4, {6, 7, kPi});
  EXPECT_GT(DisorderOf(input, state), 1);
}

TEST(Groups, WhatStandsBeforeAFrontStandsAtItsMiddleForEverySeed) {
  const v1::LayoutGraph graph =
      Parse(RoomText(4, 4) + "object_list {" + ObjectText("desk", "PRIMARY", "FLOOR", 1.4, 0.6) +
            ObjectText("chair", "SECONDARY", "FLOOR", 0.5, 0.5) + "}" +
            EdgeText("wall", "against_wall", Text("object", "desk")) +
            EdgeText("seat", "next_to",
                     Text("object", "chair") + Text("target", "desk") + Text("object_side", "front") +
                         Text("target_side", "front")));
  for (int seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    const v1::SolvedLayout layout = Solve(graph, seed, v1::GROUP_POLICY_UNSPECIFIED);
    const v1::Placement &desk = PlacementOf(layout, "desk"), &chair = PlacementOf(layout, "chair");
    const Frame<double> frame = FrameOf(Pose<double>{desk.x_m(), desk.y_m(), desk.theta_rad()});
    EXPECT_LT(std::abs(frame.ToObject({chair.x_m(), chair.y_m()}).x), 0.05);
  }
}

TEST(ForEachPattern, KeepsRowsAlongWallsOffWindows) {
  Room room = RectangularRoom(7, 10);
  for (int wall : {1, 3}) {
    Opening& window = room.openings.emplace_back();
    window.kind = OpeningKind::kWindow;
    window.wall = wall;
    window.offset_m = 4;
    window.width_m = 2;
  }
  const BoundingBox bed{{-0.5, -1}, {0.5, 1}};
  bool found = false;
  ForEachPattern(room, bed, 6, Ways::kNone, [&](const std::vector<Pose<double>>& poses) {
    found = found || std::all_of(poses.begin(), poses.begin() + 6, [&](const Pose<double>& pose) {
              const bool at_side = std::abs(std::abs(pose.x_m - 3.5) - 2.5) < 1e-6;
              return at_side && (pose.y_m < 3.0 + 1e-6 || pose.y_m > 7.0 - 1e-6);
            });
  });
  EXPECT_TRUE(found);
}

TEST(ForEachPattern, SharesOppositeWallsEvenly) {
  const Room room = RectangularRoom(7, 10);
  const BoundingBox bed{{-0.75, -1}, {0.75, 1}};
  bool found = false;
  ForEachPattern(room, bed, 6, Ways::kNone, [&](const std::vector<Pose<double>>& poses) {
    const auto at = [&](double x_m) {
      std::vector<double> y;
      for (size_t k = 0; k < 6; ++k) {
        if (std::abs(poses[k].x_m - x_m) < 1e-6) y.push_back(poses[k].y_m);
      }
      std::sort(y.begin(), y.end());
      return y;
    };
    const std::vector<double> west = at(1), east = at(6);
    found = found || (west.size() == 3 && east.size() == 3 && west[1] - west[0] > 2.1 && west[2] - west[1] > 2.1);
  });
  EXPECT_TRUE(found);
}

TEST(ForEachPattern, LeavesWaysAllRound) {
  const Room room = RectangularRoom(8, 6);
  const BoundingBox box{{-0.5, -0.4}, {0.5, 0.4}};
  const Footprint size{box.width_m(), box.height_m()};
  int grids = 0;
  ForEachPattern(room, box, 6, Ways::kAllRound, [&](const std::vector<Pose<double>>& poses) {
    const bool on_a_wall = std::ranges::any_of(
        poses, [&](const Pose<double>& pose) { return AngleBetween(pose.theta_rad, poses[0].theta_rad) > 0.1; });
    if (on_a_wall || poses.size() != 6) return;
    double least_m = HUGE_VAL;
    for (size_t a = 0; a < poses.size(); ++a) {
      for (size_t b = 0; b < a; ++b) {
        least_m = std::min(least_m,
                           Separate(Box<double>(size, FrameOf(poses[a])), Box<double>(size, FrameOf(poses[b]))).gap_m);
      }
    }
    grids += least_m > 0.5 ? 1 : 0;
    const double wall_m = std::min({poses[0].x_m, poses[0].y_m, 8 - poses[0].x_m, 6 - poses[0].y_m});
    if (wall_m > 0.6) EXPECT_GT(least_m, 0) << poses[0].x_m << ", " << poses[0].y_m;
  });
  EXPECT_GT(grids, 0);
}

TEST(ForEachPattern, PlacesSoManyBoxesThatDoNotOverlap) {
  const Room room = RectangularRoom(8, 6);
  const BoundingBox box{{-0.5, -0.9}, {0.7, 0.4}};
  const Footprint size{box.width_m(), box.height_m()};
  int patterns = 0;
  ForEachPattern(room, box, 7, Ways::kNone, [&](const std::vector<Pose<double>>& poses) {
    ++patterns;
    ASSERT_GE(poses.size(), 7u);
    std::vector<Box<double>> boxes;
    for (const Pose<double>& pose : poses) {
      const Vec2<double> middle = FrameOf(pose).ToRoom(box.Center().x, box.Center().y);
      boxes.emplace_back(size, FrameOf(Pose<double>{middle.x, middle.y, pose.theta_rad}));
      for (size_t k = 0; k + 1 < boxes.size(); ++k) ASSERT_GT(Separate(boxes[k], boxes.back()).gap_m, -1e-6);
    }
  });
  EXPECT_GT(patterns, 100);
}

}  // namespace
}  // namespace flair::optimizer
