// SPDX-License-Identifier: GPL-3.0-or-later
// testdata/small_study.json is written for these tests, in the format and with the habits of the recorded problems.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "evaluation/readers/flairgpt_calls.h"
#include "nlohmann/json.hpp"
#include "room/conversion/conversion.h"

namespace flair::evaluation {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

std::string StudyText() {
  std::ifstream file(FLAIR_SOURCE_DIR "/evaluation/readers/testdata/small_study.json");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

v1::LayoutGraph Study() {
  const absl::StatusOr<v1::LayoutGraph> graph = ReadFlairGptRoom(StudyText());
  EXPECT_TRUE(graph.ok()) << graph.status();
  return graph.value_or(v1::LayoutGraph());
}

// The study with one value changed, as text.
std::string StudyWith(const std::string& pointer, const json& value) {
  json study = json::parse(StudyText());
  study[json::json_pointer(pointer)] = value;
  return study.dump();
}

std::vector<std::string> TypesOf(const v1::LayoutGraph& graph) {
  std::vector<std::string> types;
  for (const v1::ConstraintEdge& edge : graph.edges()) types.push_back(edge.type());
  return types;
}

// The first edge of a type as "name=value name=value".
std::string ArgumentsOf(const v1::LayoutGraph& graph, const std::string& type, int skip = 0) {
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (edge.type() != type || skip-- > 0) continue;
    std::string text;
    for (const v1::Argument& argument : edge.arguments()) {
      const v1::ArgumentValue& value = argument.value();
      text += (text.empty() ? "" : " ") + argument.name() + "=";
      if (value.has_number()) text += json(value.number()).dump();
      if (value.has_flag()) text += value.flag() ? "true" : "false";
      if (value.has_text()) text += value.text();
      for (const std::string& item : value.texts().items()) text += item + ",";
    }
    return text;
  }
  return "none";
}

TEST(FlairGptRoom, IsAValidGraph) {
  const absl::StatusOr<Scene> scene = SceneFromProto(Study());
  ASSERT_TRUE(scene.ok()) << scene.status();
  EXPECT_EQ(scene->objects.size(), 7u);
  EXPECT_EQ(scene->zones.size(), 2u);
  EXPECT_TRUE(scene->objects[static_cast<size_t>(scene->IndexOf("item_0"))].walk_over);
}

TEST(FlairGptRoom, PositionsAreSharesOfWhatTheOpeningLeavesOfTheWall) {
  const v1::LayoutGraph graph = Study();
  const v1::Opening& door = graph.room().openings(0);
  EXPECT_EQ(door.kind(), v1::OPENING_KIND_DOOR);
  EXPECT_DOUBLE_EQ(door.offset_m(), 0);
  // West is walked from north to south: 0.5 of the 2.2 m left.
  const v1::Opening& west = graph.room().openings(2);
  EXPECT_EQ(west.wall(), "west");
  EXPECT_DOUBLE_EQ(west.offset_m(), 1.1);
  ASSERT_EQ(graph.room().sockets_size(), 1);
  EXPECT_DOUBLE_EQ(graph.room().sockets(0).offset_m(), 0.5 * 2.9 + 0.05);
}

TEST(FlairGptRoom, WindowsThatOverlapBecomeOne) {
  const v1::LayoutGraph graph = Study();
  ASSERT_EQ(graph.room().openings_size(), 3);
  const v1::Opening& north = graph.room().openings(1);
  EXPECT_EQ(north.wall(), "north");
  // From 0.75 to 2.5 m from the west end, walked from the east.
  EXPECT_DOUBLE_EQ(north.offset_m(), 1.5);
  EXPECT_DOUBLE_EQ(north.width_m(), 1.75);
}

TEST(FlairGptRoom, CallsBecomeEdgesUnderOurNamesWithoutRepeats) {
  EXPECT_THAT(TypesOf(Study()), ElementsAre("against_wall", "accessible", "facing", "in_zone", "not_against_wall",
                                            "near", "away_from", "away_from", "parallel", "rug_under_center",
                                            "on_top_corner", "on_wall_above", "ceiling_center"));
}

TEST(FlairGptRoom, ArgumentsAreReadByPositionAndByKeyword) {
  const v1::LayoutGraph graph = Study();
  EXPECT_EQ(ArgumentsOf(graph, "against_wall"), "object=floor_0 side=back");
  EXPECT_EQ(ArgumentsOf(graph, "facing"), "object=floor_1 target=floor_0 both=true");
  EXPECT_EQ(ArgumentsOf(graph, "rug_under_center"), "rug=item_0 object=floor_2");
  EXPECT_EQ(ArgumentsOf(graph, "on_top_corner"), "object=item_1 host=floor_0 corner=back_right");
}

TEST(FlairGptRoom, ALoneNumberAfterTheObjectIsADistance) {
  EXPECT_EQ(ArgumentsOf(Study(), "accessible"), "object=floor_0 min_clearance_m=0.7");
}

TEST(FlairGptRoom, WallsAndFurnitureInPlaceOfFeaturesAreReadAsWhatTheyAre) {
  const v1::LayoutGraph graph = Study();
  EXPECT_EQ(ArgumentsOf(graph, "not_against_wall"), "object=floor_2 min_distance_m=0.3");
  EXPECT_EQ(ArgumentsOf(graph, "near"), "object=floor_2 target=floor_0 max_distance_m=1.5");
}

TEST(FlairGptRoom, SeveralPartnersAreSeveralEdges) {
  const v1::LayoutGraph graph = Study();
  EXPECT_EQ(ArgumentsOf(graph, "away_from", 0), "object=floor_2 target=floor_0 min_distance_m=0.5");
  EXPECT_EQ(ArgumentsOf(graph, "away_from", 1), "object=floor_2 target=floor_1 min_distance_m=0.5");
}

TEST(FlairGptRoom, ZonesAreFoundWithoutTheWordArea) {
  EXPECT_EQ(ArgumentsOf(Study(), "in_zone"), "object=floor_2 zone=reading_area");
}

TEST(FlairGptRoom, CallsThatMeanNothingBecomeOneDiagnosticEach) {
  const v1::LayoutGraph graph = Study();
  std::vector<std::string> messages;
  for (const v1::Diagnostic& diagnostic : graph.diagnostics()) messages.push_back(diagnostic.message());
  EXPECT_THAT(messages, UnorderedElementsAre("ind_away_from_fixed_object(0, \"radiator\"): no feature \"radiator\"",
                                             "ind_teleport(2): unknown function ind_teleport",
                                             HasSubstr("7: not a call"), "on_top_central(9, 0): no object 9"));
}

TEST(FlairGptRoom, TextOfAnotherKindIsRefusedWithAReason) {
  for (const std::string& text : {std::string(), std::string("{"), std::string("[]"), std::string("{\"room\": 3}"),
                                  StudyWith("/room/width", "wide"), StudyWith("/primary/0/index", "first"),
                                  StudyWith("/calls", nullptr), StudyWith("/secondary", 5)}) {
    const absl::StatusOr<v1::LayoutGraph> graph = ReadFlairGptRoom(text);
    EXPECT_EQ(graph.status().code(), absl::StatusCode::kInvalidArgument) << text.substr(0, 80);
    EXPECT_THAT(std::string(graph.status().message()), HasSubstr("not a recorded FlairGPT problem"));
  }
}

TEST(FlairGptRoom, ARefusalNamesFieldValueAndWhatWouldBeRight) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"{\n\"a\":", "not JSON: parse error at line 2, column 5"},
      {"{\"room\": {\"width\": NaN}}", "not JSON: parse error at line 1"},
      {"[1]", "[1] is not an object"},
      {StudyWith("/room/width", "wide"), "room.width: \"wide\" should be a number in (0, 100], metres"},
      {StudyWith("/room/length", -3), "room.length: -3 should be a number in (0, 100], metres"},
      {StudyWith("/room", json::object()), "room.width: is missing; should be a number in (0, 100], metres"},
      {StudyWith("/zones/1", 4), "zones[1]: 4 should be text, a name"},
      {StudyWith("/fixed_objects/0/wall", "up"), "fixed_objects[0].wall: \"up\" should be south, east, north or west"},
      {StudyWith("/fixed_objects/2/width", "x"),
       "fixed_objects[2].width: \"x\" should be a number in [0, 100], metres"},
      {StudyWith("/primary/0/width", nullptr), "primary[0].width: null should be a number in [0, 20], metres"},
      {StudyWith("/secondary/1/length", 1e9), "secondary[1].length: 1000000000.0 should be a number in [0, 20]"},
      {StudyWith("/tertiary/3/width", -0.1), "tertiary[3].width: -0.1 should be a number in [0, 20], metres"},
      {StudyWith("/secondary/0/index", 0),
       "secondary[0].index: 0 should be a whole number that no other such object has"},
      {StudyWith("/primary/0/index", 0.5), "primary[0].index: 0.5 should be a whole number"},
      {StudyWith("/primary/0/name", 7), "primary[0].name: 7 should be text"},
      {StudyWith("/tertiary", 5), "tertiary: 5 should be a list"},
      {StudyWith("/calls/tertiary", "none"), "calls.tertiary: \"none\" should be a list"},
      {StudyWith("/calls", nullptr), "calls: null should be an object"}};
  for (const auto& [text, message] : cases) {
    const absl::StatusOr<v1::LayoutGraph> graph = ReadFlairGptRoom(text);
    EXPECT_EQ(graph.status().code(), absl::StatusCode::kInvalidArgument) << message;
    EXPECT_THAT(std::string(graph.status().message()), HasSubstr("not a recorded FlairGPT problem: " + message));
  }
}

TEST(FlairGptRoom, AtMostFiveFaultsAreListed) {
  json study = json::parse(StudyText());
  for (json& object : study["tertiary"]) object["width"] = object["length"] = "x";
  const std::string message(ReadFlairGptRoom(study.dump()).status().message());
  EXPECT_EQ(std::count(message.begin(), message.end(), ';'), 4) << message;
}

TEST(FlairGptFunctions, AllThatTheReferenceHasAndThatModelsCallWithAMeaningAreKnown) {
  for (const char* name :
       {"ind_next_to_wall", "ind_near_wall", "ind_in_corner", "ind_not_in_corner", "ind_parallel_to_wall",
        "ind_close_to_fixed_object", "ind_away_from_fixed_object", "ind_accessible", "ind_central", "ind_in_region",
        "ind_not_block_fixed_object", "ind_under_window", "ind_facing_into_room", "ind_not_against_wall", "io_next_to",
        "io_away_from", "io_near", "io_parallel", "io_facing", "io_not_facing", "io_infront", "io_perp", "io_surround",
        "io_between", "io_on", "io_under_central", "rug_under_central", "rug_under_central_forward", "on_top_central",
        "on_top_corner", "on_wall_near", "on_wall_above_central", "on_wall_in_region", "center_ceiling",
        "ceiling_above",
        // Slips and names of other versions.
        "p_next_to", "p_facing", "ind_not_facing", "ind_facing", "ind_away_from", "ind_next_to", "io_min_dist",
        "io_accessible", "io_next_to_wall", "io_near_wall", "io_in_region", "io_central", "io_in_corner",
        "ind_near_fixed_object", "ind_near", "ind_not_next_to_wall", "on_top_center", "on_wall_above"}) {
    EXPECT_NE(FindFlairGptFunction(CanonicalFlairGptName(name)), nullptr) << name;
  }
  for (const char* name : {"ind_near_plumbing_lines", "io_air_breaks", "ind_not_in_pathway", "in_bounds", ""}) {
    EXPECT_EQ(FindFlairGptFunction(CanonicalFlairGptName(name)), nullptr) << name;
  }
}

TEST(FlairGptRoom, OddCallsCostOnlyThemselves) {
  for (const json& call :
       {json(nullptr), json(3), json::array(), json{{"function", 3}}, json{{"args", {1}}},
        json{{"function", "io_near"}, {"args", "0"}}, json{{"function", "io_near"}, {"args", {0, 1e300}}},
        json{{"function", "ind_next_to_wall"}, {"args", {0.5}}},
        json{{"function", "io_near"}, {"args", {0, {0, json::array()}}}}}) {
    const absl::StatusOr<v1::LayoutGraph> graph = ReadFlairGptRoom(StudyWith("/calls/primary/0", call));
    ASSERT_TRUE(graph.ok()) << call << graph.status();
    EXPECT_EQ(graph->edges_size(), 12) << call;
    EXPECT_EQ(graph->diagnostics_size(), 5) << call;
  }
}

TEST(FlairGptSolution, RoundTripKeepsIndicesSizesAndPoses) {
  const v1::LayoutGraph graph = Study();
  const absl::StatusOr<v1::SolvedLayout> layout = ReadFlairGptSolution(StudyText(), graph);
  ASSERT_TRUE(layout.ok()) << layout.status();
  const json study = json::parse(StudyText()), written = json::parse(WriteFlairGptLayout(*layout, "small_study", 1.5));
  EXPECT_EQ(written["name"], "small_study");
  EXPECT_EQ(written["seconds"], 1.5);
  ASSERT_EQ(written["objects"].size(), 7u);
  size_t next = 0;
  for (const char* role : {"primary", "secondary", "tertiary"}) {
    for (size_t i = 0; i < study[role].size(); ++i) {
      const json& object = written["objects"][next++];
      EXPECT_EQ(object["role"], role);
      for (const char* field : {"name", "index", "width", "length"}) EXPECT_EQ(object[field], study[role][i][field]);
      const json& pose = study["solution"][role][i];
      EXPECT_EQ(object["x"], pose[0]);
      EXPECT_EQ(object["y"], pose[1]);
      EXPECT_NEAR(std::remainder(object["theta"].get<double>() - pose[2].get<double>(), 2 * M_PI), 0, 1e-12);
    }
  }
}

TEST(FlairGptSolution, IsNotFoundWhenPosesAreMissing) {
  for (const std::string& text : {StudyWith("/solution", nullptr), StudyWith("/solution/primary", json::array()),
                                  StudyWith("/solution/primary/0", json::array({1}))}) {
    EXPECT_EQ(ReadFlairGptSolution(text, Study()).status().code(), absl::StatusCode::kNotFound);
  }
}

TEST(FlairGptLayout, ObjectsOfOtherGraphsAreNumberedInOrder) {
  v1::SolvedLayout layout;
  for (const char* id : {"bed_1", "lamp_9999999999999", "rug"}) {
    v1::Object* object = layout.mutable_graph()->mutable_object_list()->add_objects();
    object->set_id(id);
    object->set_role(std::string(id) == "rug" ? v1::OBJECT_ROLE_TERTIARY : v1::OBJECT_ROLE_PRIMARY);
    layout.add_placements()->set_object_id(id);
  }
  const json written = json::parse(WriteFlairGptLayout(layout, "own", 0));
  EXPECT_EQ(written["objects"][0]["index"], 0);
  EXPECT_EQ(written["objects"][1]["index"], 1);
  EXPECT_EQ(written["objects"][2]["index"], 0);
}

}  // namespace
}  // namespace flair::evaluation
