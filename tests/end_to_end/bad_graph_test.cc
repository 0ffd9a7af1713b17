// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs that nobody should send, as a user sends them: `flair solve FILE`. Refused with a message that names the field
// and what would be right, and no file; or solved, with a remark that names the culprit.
#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;

v1::LayoutGraph Bedroom() {
  v1::LayoutGraph graph;
  const std::string text = ReadAll(std::string(FLAIR_SOURCE_DIR) + "/tests/fuzz/corpus/read_graph/bedroom.textproto");
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &graph));
  return graph;
}

void SetFloor(v1::LayoutGraph& graph, const std::vector<std::pair<double, double>>& corners) {
  graph.mutable_room()->mutable_floor()->clear_vertices();
  for (const auto& [x, y] : corners) {
    v1::Point2& p = *graph.mutable_room()->mutable_floor()->add_vertices();
    p.set_x_m(x);
    p.set_y_m(y);
  }
}

v1::ConstraintEdge& AddEdge(v1::LayoutGraph& graph, const std::string& type,
                            const std::vector<std::pair<std::string, std::string>>& arguments) {
  v1::ConstraintEdge& edge = *graph.add_edges();
  edge.set_id(fmt::format("new_{}", graph.edges_size()));
  edge.set_type(type);
  edge.set_weight(1);
  for (const auto& [name, text] : arguments) {
    v1::Argument& argument = *edge.add_arguments();
    argument.set_name(name);
    argument.mutable_value()->set_text(text);
  }
  return edge;
}

v1::Object& Bed(v1::LayoutGraph& graph) { return *graph.mutable_object_list()->mutable_objects(0); }
v1::Opening& Door(v1::LayoutGraph& graph) { return *graph.mutable_room()->mutable_openings(0); }

void AddObjects(v1::LayoutGraph& graph, int count) {
  for (int i = 0; i < count; ++i) {
    v1::Object& object = *graph.mutable_object_list()->add_objects();
    object = graph.object_list().objects(0);
    object.set_id(fmt::format("piece_{}", i));
  }
}

struct Case {
  const char* name;
  std::function<void(v1::LayoutGraph&)> spoil;
  const char* message;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class GraphFile : public ::testing::TestWithParam<Case> {
 protected:
  Finished Solve(const std::string& bytes) const {
    WriteAll(folder_ / "graph.pb", bytes);
    return RunProgram("flair", {"solve", folder_ / "graph.pb", "--out", folder_ / "layout.pb", "--threads", "1"},
                      {{"FLAIR_HOME", folder_ / "home"}});
  }
  Finished SolveSpoiled() const {
    v1::LayoutGraph graph = Bedroom();
    GetParam().spoil(graph);
    return Solve(cli::GraphArtifactBytes(graph, "test", ""));
  }
  bool Written() const { return std::filesystem::exists(folder_ / "layout.pb"); }

  TestFolder folder_;
};

class RefusedGraph : public GraphFile {};

TEST_P(RefusedGraph, NamesTheFieldAndLeavesNoFile) {
  const Finished run = SolveSpoiled();
  EXPECT_EQ(run.exit_code, cli::kExitBadInput) << run.err;
  EXPECT_THAT(run.err, HasSubstr(GetParam().message));
  EXPECT_FALSE(Written());
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

INSTANTIATE_TEST_SUITE_P(
    Graphs, RefusedGraph,
    ::testing::Values(
        Case{"NanSize", [](auto& g) { Bed(g).set_width_m(kNan); }, "objects[0].width_m: nan is not a number"},
        Case{"InfiniteSize", [](auto& g) { Bed(g).set_depth_m(kInfinity); }, "depth_m: inf is not a number"},
        Case{"ZeroSize", [](auto& g) { Bed(g).set_width_m(0); }, "width_m: 0 is outside (0, 20]"},
        Case{"NegativeSize", [](auto& g) { Bed(g).set_height_m(-1); }, "height_m: -1 is outside (0, 12]"},
        Case{"NanCorner", [](auto& g) { SetFloor(g, {{0, 0}, {kNan, 0}, {4, 3}, {0, 3}}); }, "is not a point"},
        Case{"CrossedFloor", [](auto& g) { SetFloor(g, {{0, 0}, {4, 3}, {4, 0}, {0, 3}}); },
             "room.floor: is not simple"},
        Case{"ClockwiseFloor", [](auto& g) { SetFloor(g, {{0, 0}, {0, 3}, {4, 3}, {4, 0}}); }, "runs clockwise"},
        Case{"HugeRoom", [](auto& g) { SetFloor(g, {{0, 0}, {101, 0}, {101, 3}, {0, 3}}); }, "is 101 m x 3 m"},
        Case{"NoObjects", [](auto& g) { g.mutable_object_list()->clear_objects(); }, "has 0 objects; at least 1"},
        Case{"TooManyObjects", [](auto& g) { AddObjects(g, 249); }, "has 251 objects; at most 250"},
        Case{"TooManyEdges",
             [](auto& g) {
               while (g.edges_size() <= 4000) AddEdge(g, "near", {});
             },
             "has 4001 edges; at most 4000"},
        Case{"DoorsThatOverlap",
             [](auto& g) {
               v1::Opening second = Door(g);
               second.set_id("door_2");
               second.set_offset_m(0.5);
               *g.mutable_room()->add_openings() = second;
             },
             "openings[1]: overlaps layout_graph.room.openings[0]"},
        Case{"DoorBesideItsWall", [](auto& g) { Door(g).set_offset_m(3.9); }, "does not fit wall \"south\""},
        Case{"DoorInNoWall", [](auto& g) { Door(g).set_wall("up"); }, "\"up\" is not a wall here; there are east"},
        Case{"TwoOfOneId", [](auto& g) { *g.mutable_object_list()->add_objects() = Bed(g); },
             "\"bed\" is taken already"},
        Case{"HugeId", [](auto& g) { Bed(g).set_id(std::string(1000000, 'b')); }, "is not an id; 1 to 64"},
        Case{"NanWeight", [](auto& g) { g.mutable_edges(0)->set_weight(kNan); }, "edges[0].weight: nan"}),
    [](const auto& info) { return std::string(info.param.name); });

class OddGraph : public GraphFile {};

TEST_P(OddGraph, IsSolvedWithARemark) {
  const Finished run = SolveSpoiled();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr(GetParam().message));
  EXPECT_TRUE(Written());
}

INSTANTIATE_TEST_SUITE_P(
    Graphs, OddGraph,
    ::testing::Values(
        Case{"LargerThanTheRoom", [](auto& g) { Bed(g).set_width_m(9); },
             "the bed (9.00 m x 2.00 m) reaches out of the room"},
        Case{"UnknownType", [](auto& g) { AddEdge(g, "hug", {{"object", "bed"}}); }, "hug"},
        Case{"UnknownObject", [](auto& g) { AddEdge(g, "against_wall", {{"object", "yeti"}}); }, "yeti"},
        Case{"UnknownParameter", [](auto& g) { AddEdge(g, "against_wall", {{"object", "bed"}, {"colour", "red"}}); },
             "colour"},
        Case{"BetweenItself",
             [](auto& g) { AddEdge(g, "between", {{"object", "bed"}, {"first", "bed"}, {"second", "bed"}}); },
             "dropped"},
        Case{"BetweenInACircle",
             [](auto& g) {
               AddObjects(g, 2);
               for (int i = 1; i < 3; ++i) g.mutable_object_list()->mutable_objects(i)->set_zone_id("sleeping");
               AddEdge(g, "between", {{"object", "bed"}, {"first", "piece_0"}, {"second", "piece_1"}});
               AddEdge(g, "between", {{"object", "piece_0"}, {"first", "piece_1"}, {"second", "bed"}});
               AddEdge(g, "between", {{"object", "piece_1"}, {"first", "bed"}, {"second", "piece_0"}});
             },
             "4 objects placed"},
        Case{"NoDoors", [](auto& g) { g.mutable_room()->clear_openings(); }, "2 objects placed"},
        Case{"RoomOfOneMetre", [](auto& g) { SetFloor(g, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }, "no free place of"},
        Case{"RoomOfAHundredMetres", [](auto& g) { SetFloor(g, {{0, 0}, {100, 0}, {100, 100}, {0, 100}}); },
             "2 objects placed"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST_F(GraphFile, CutOffOrNestedWithoutEndIsNoArtifact) {
  const std::string good = cli::GraphArtifactBytes(Bedroom(), "test", "");
  std::string nested;
  for (int i = 0; i < 100000; ++i) nested += "{\"layoutGraph\":";
  const std::tuple<std::string, int, const char*> files[] = {
      {good.substr(0, 1), cli::kExitCorrupt, "not a Flair artifact"},
      {good.substr(0, good.size() / 2), cli::kExitCorrupt, "corrupt: cut off"},
      {good.substr(0, good.size() - 1), cli::kExitCorrupt, "corrupt: cut off after"},
      {nested, cli::kExitBadInput, ":1: "},
      {std::string(1000, '\0'), cli::kExitCorrupt, "not a Flair artifact"},
      {"", cli::kExitCorrupt, "the file is empty"}};
  for (const auto& [bytes, code, words] : files) {
    const Finished run = Solve(bytes);
    EXPECT_EQ(run.exit_code, code) << run.err;
    EXPECT_THAT(run.err, HasSubstr(words));
    EXPECT_FALSE(Written());
  }
}

TEST_F(GraphFile, ARefusalKeepsTheLayoutThatWasThere) {
  WriteAll(folder_ / "layout.pb", "mine");
  EXPECT_NE(Solve("garbage").exit_code, 0);
  EXPECT_EQ(ReadAll(folder_ / "layout.pb"), "mine");
}

}  // namespace
}  // namespace flair::testing
