// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/validate.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

#include "flair/rules/v1/rules.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "tests/fixtures/bedroom.h"

namespace flair {
namespace {

using ::testing::HasSubstr;

std::string Text(const absl::Status& status) { return std::string(status.message()); }

// With a window and a socket, so that there is something of every kind to spoil.
v1::Room GoodRoom() {
  v1::Room room = testing::BedroomRoom();
  EXPECT_TRUE(google::protobuf::TextFormat::MergeFromString(
      R"pb(
        openings {
          id: "window_1"
          kind: OPENING_KIND_WINDOW
          wall: "north"
          offset_m: 1
          width_m: 1.5
          sill_height_m: 0.9
          head_height_m: 2.1
        }
        sockets { id: "socket_1" wall: "east" offset_m: 2 height_m: 0.3 })pb",
      &room));
  return room;
}

v1::LayoutGraph GoodGraph() {
  v1::LayoutGraph graph;
  *graph.mutable_room() = GoodRoom();
  *graph.mutable_zone_plan() = testing::BedroomZones();
  *graph.mutable_object_list()->add_objects() = testing::BedroomBed();
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(
      R"pb(
        id: "lamp"
        name: "lamp"
        role: OBJECT_ROLE_TERTIARY
        kind: OBJECT_KIND_SURFACE
        width_m: 0.2
        depth_m: 0.2
        height_m: 0.4
        host_id: "bed")pb",
      graph.mutable_object_list()->add_objects()));
  *graph.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
  *graph.add_edges() = testing::BedroomEdge();
  return graph;
}

TEST(ValidateRoom, AcceptsAGoodOne) { EXPECT_EQ(Text(Validate(GoodRoom())), ""); }

struct BadRoom {
  std::string name;
  std::function<void(v1::Room&)> spoil;
  std::string message;
};

class ValidateRoomTest : public ::testing::TestWithParam<BadRoom> {};

TEST_P(ValidateRoomTest, NamesFieldAndValue) {
  v1::Room room = GoodRoom();
  GetParam().spoil(room);
  const absl::Status status = Validate(room);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(Text(status), HasSubstr(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    Rooms, ValidateRoomTest,
    ::testing::Values(
        BadRoom{"WideWindow", [](v1::Room& r) { r.mutable_openings(1)->set_width_m(7.2); },
                "room.openings[1].width_m: 7.2 does not fit wall \"north\" (4 m from 1 m); at most 3"},
        BadRoom{"UnknownWall", [](v1::Room& r) { r.mutable_openings(1)->set_wall("norht"); },
                "room.openings[1].wall: \"norht\" is not a wall here; there are east, north, south, west"},
        BadRoom{"NoLeaf", [](v1::Room& r) { r.mutable_openings(0)->clear_leaf(); },
                "room.openings[0].leaf: is not set"},
        BadRoom{"SillOfADoor", [](v1::Room& r) { r.mutable_openings(0)->set_sill_height_m(0.2); },
                "room.openings[0].sill_height_m: 0.2 for a door; must be 0"},
        BadRoom{"HeadAboveCeiling", [](v1::Room& r) { r.mutable_openings(1)->set_head_height_m(3.5); },
                "room.openings[1].head_height_m: 3.5 is outside (0.9, 3]"},
        BadRoom{"RepeatedId", [](v1::Room& r) { r.mutable_openings(1)->set_id("door_1"); },
                "room.openings[1].id: \"door_1\" is taken already"},
        BadRoom{"NotFinite", [](v1::Room& r) { r.set_height_m(std::numeric_limits<double>::quiet_NaN()); },
                "room.height_m: nan is not a number"},
        BadRoom{"Clockwise", [](v1::Room& r) { r.mutable_floor()->mutable_vertices()->SwapElements(1, 3); },
                "runs clockwise"},
        BadRoom{"CrossedEdges",
                [](v1::Room& r) {
                  r.mutable_floor()->mutable_vertices(2)->set_x_m(0.5);
                  r.mutable_floor()->mutable_vertices(2)->set_y_m(-0.5);
                },
                "room.floor"},
        BadRoom{"NotAtTheOrigin",
                [](v1::Room& r) {
                  for (auto& p : *r.mutable_floor()->mutable_vertices()) p.set_x_m(p.x_m() + 1);
                },
                "room.floor: its bounding box starts at (1, 0); must start at (0, 0)"},
        BadRoom{"TooLarge", [](v1::Room& r) { r.mutable_floor()->mutable_vertices(1)->set_x_m(200); },
                "each must be in [1, 100]"},
        BadRoom{"MissingWall", [](v1::Room& r) { r.mutable_walls()->RemoveLast(); }, "one per edge"},
        BadRoom{"SocketBeyondItsWall", [](v1::Room& r) { r.mutable_sockets(0)->set_offset_m(6); },
                "room.sockets[0].offset_m: 6 is outside [0, 5"}),
    [](const auto& info) { return info.param.name; });

TEST(ValidateRoom, OpeningsMayNotOverlapOnOneWall) {
  v1::Room room = GoodRoom();
  *room.add_openings() = room.openings(1);
  room.mutable_openings(2)->set_id("window_2");
  EXPECT_THAT(Text(Validate(room)), HasSubstr("room.openings[2]: overlaps room.openings[1]"));
  room.mutable_openings(2)->set_sill_height_m(2.2);
  room.mutable_openings(2)->set_head_height_m(2.8);
  EXPECT_EQ(Text(Validate(room)), "") << "one window above another";
}

TEST(ValidateBrief, RefusesWhatIsNoWish) {
  v1::Brief brief;
  for (const std::string& text : {"", "   \t ", "\xF0\x9F\x9B\x8F\xF0\x9F\x9B\x8B", "!!! 12 ??",
                                  "a\x01"
                                  "b"}) {
    brief.set_text(text);
    EXPECT_THAT(Text(Validate(brief)), HasSubstr("brief.text: ")) << text;
  }
  brief.set_text(std::string(100000, 'x'));
  EXPECT_EQ(Text(Validate(brief)), "brief.text: has 100000 characters; at most 4000");
}

TEST(ValidateBrief, TakesAnyScriptAndEmojiBesideWords) {
  v1::Brief brief;
  for (const std::string& text : {"A bedroom.", "寝室", "спальня", "ein Büro", "A bedroom \xF0\x9F\x9B\x8F", "é"}) {
    brief.set_text(text);
    EXPECT_EQ(Text(Validate(brief)), "") << text;
  }
}

TEST(ValidateBrief, SeedEndsBeforeTwoToThe53) {
  v1::Brief brief;
  brief.set_text("A bedroom.");
  brief.set_seed((int64_t{1} << 53) - 1);
  EXPECT_TRUE(Validate(brief).ok());
  brief.set_seed(int64_t{1} << 53);
  EXPECT_THAT(Text(Validate(brief)), HasSubstr("brief.seed"));
}

TEST(ValidateBrief, ChecksThePartsThatItBrings) {
  const v1::LayoutGraph graph = GoodGraph();
  v1::Brief brief;
  brief.set_text("A bedroom.");
  *brief.mutable_room() = graph.room();
  *brief.mutable_zone_plan() = graph.zone_plan();
  *brief.mutable_object_list() = graph.object_list();
  *brief.mutable_constraint_list() = graph.constraint_list();
  EXPECT_EQ(Text(Validate(brief)), "");
  brief.mutable_object_list()->mutable_objects(0)->set_zone_id("attic");
  EXPECT_THAT(Text(Validate(brief)), HasSubstr("brief.object_list.objects[0].zone_id: \"attic\" is not a zone here"));
  brief.clear_zone_plan();
  EXPECT_EQ(Text(Validate(brief)), "") << "zones are planned for the objects then";
  brief.mutable_zone_plan();
  EXPECT_THAT(Text(Validate(brief)), HasSubstr("brief.zone_plan.zones: has 0 zones"));
}

TEST(ValidateRequests, ABudgetIsNotNegative) {
  v1::DescribeRoomRequest request;
  request.mutable_brief()->set_text("A bedroom.");
  request.mutable_model_options()->mutable_budget()->set_token_count(-1);
  EXPECT_EQ(Text(Validate(request)), "model_options.budget.token_count: -1 is outside [0, 1000000000]");
}

TEST(ValidateLayoutGraph, AcceptsAGoodOne) { EXPECT_EQ(Text(Validate(GoodGraph())), ""); }

TEST(ValidateLayoutGraph, FollowsReferences) {
  v1::LayoutGraph graph = GoodGraph();
  graph.mutable_object_list()->mutable_objects(0)->set_zone_id("working");
  graph.mutable_object_list()->mutable_objects(1)->set_host_id("sofa");
  graph.mutable_constraint_list()->mutable_sentences(0)->set_subject_ids(0, "chair");
  graph.mutable_edges(0)->set_sentence_id("s9");
  const std::string text = Text(Validate(graph));
  EXPECT_THAT(
      text,
      HasSubstr("layout_graph.object_list.objects[0].zone_id: \"working\" is not a zone here; there is sleeping"));
  EXPECT_THAT(text, HasSubstr("objects[1].host_id: \"sofa\" is not an object here"));
  EXPECT_THAT(text, HasSubstr("sentences[0].subject_ids[0]: \"chair\" is not an object here"));
  EXPECT_THAT(text, HasSubstr("edges[0].sentence_id: \"s9\" is not a sentence here"));
}

TEST(ValidateLayoutGraph, RefusesMeaningsThatMeanNothing) {
  v1::LayoutGraph graph = GoodGraph();
  v1::Meaning& meaning = *graph.mutable_constraint_list()->mutable_sentences(0)->mutable_meaning();
  v1::Fact& fact = *meaning.add_facts();
  const auto with = [&](const char* text) {
    EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &fact)) << text;
    return Text(Validate(graph));
  };
  EXPECT_THAT(with(R"(relation: "against")"), HasSubstr("sentences[0].meaning.text_digest: "));
  meaning.set_text_digest(std::string(64, 'a'));
  EXPECT_EQ(with(R"(relation: "against" movers { object_id: "bed" side: PARTICIPANT_SIDE_BACK })"), "");
  EXPECT_THAT(with(R"(relation: "drop table")"), HasSubstr("facts[0].relation: \"drop table\""));
  EXPECT_THAT(with(R"(relation: "near" targets { object_id: "sofa" })"),
              HasSubstr("facts[0].targets[0].object_id: \"sofa\" is not an object here"));
  EXPECT_THAT(with(R"(relation: "near" targets { zone_id: "attic" })"),
              HasSubstr("facts[0].targets[0].zone_id: \"attic\" is not a zone here"));
  EXPECT_THAT(with(R"(relation: "near" targets { side: PARTICIPANT_SIDE_BACK })"),
              HasSubstr("facts[0].targets[0].object_id: is not set, nor zone_id, wall or part"));
  EXPECT_THAT(with(R"(relation: "near" targets { part: 99 })"), HasSubstr("facts[0].targets[0].part: 99"));
  EXPECT_THAT(with(R"(relation: "near" measure { max_m: 1e9 })"),
              HasSubstr("facts[0].measure.max_m: 1000000000 is outside [0, 100]"));
  EXPECT_THAT(with(R"(relation: "near" measure { max_m: nan })"), HasSubstr("facts[0].measure.max_m: nan"));
  EXPECT_THAT(with(R"(relation: "near" measure { min_m: 2 max_m: 1 })"),
              HasSubstr("facts[0].measure.min_m: 2 is above max_m 1"));
  EXPECT_THAT(with(R"(relation: "near" measure { })"), HasSubstr("facts[0].measure.min_m: is not set, nor is max_m"));
  fact.set_relation("near");
  fact.clear_measure();
  for (int i = 0; i < 100; ++i) *meaning.add_facts() = fact;
  EXPECT_THAT(Text(Validate(graph)), HasSubstr("meaning.facts: has 101 facts"));
}

TEST(ValidateLayoutGraph, ReportsAtMostFiveProblemsAndCountsTheRest) {
  v1::LayoutGraph graph = GoodGraph();
  for (int i = 0; i < 8; ++i) graph.add_edges();
  EXPECT_THAT(Text(Validate(graph)), HasSubstr("more"));
}

TEST(ValidateSolvedLayout, RefusesPlacementsOfUnknownOrRepeatedObjects) {
  v1::SolvedLayout layout;
  *layout.mutable_graph() = GoodGraph();
  layout.add_placements()->set_object_id("bed");
  EXPECT_EQ(Text(Validate(layout)), "");
  layout.add_placements()->set_object_id("bed");
  layout.add_placements()->set_object_id("cupboard");
  layout.mutable_placements(0)->set_theta_rad(-1);
  const std::string text = Text(Validate(layout));
  EXPECT_THAT(text, HasSubstr("solved_layout.placements[1].object_id: \"bed\" is taken already"));
  EXPECT_THAT(text, HasSubstr("solved_layout.placements[2].object_id: \"cupboard\" is not an object here"));
  EXPECT_THAT(text, HasSubstr("solved_layout.placements[0].theta_rad: -1 is outside [0, 6.28"));
}

TEST(ValidateOptions, UnsetFieldsAreDefaultsAndSetOnesAreInRange) {
  v1::SolveOptions solve;
  EXPECT_TRUE(Validate(solve).ok());
  solve.set_thread_count(0);
  EXPECT_EQ(Text(Validate(solve)), "options.thread_count: 0 is outside [1, 256]");
  v1::RenderOptions render;
  render.set_size_px(100);
  EXPECT_EQ(Text(Validate(render)), "options.size_px: 100 is outside [256, 8192]");
}

TEST(Rules, AreAboutFieldsThatExist) {
  std::ifstream file(std::string(FLAIR_SOURCE_DIR) + "/room/validation/rules.textproto");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  rules::v1::Rules rules;
  ASSERT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &rules));
  // The linker takes the descriptors of what is used only.
  EXPECT_FALSE(v1::TranslateRequest::descriptor() == nullptr || v1::DescribeRoomRequest::descriptor() == nullptr);
  EXPECT_GT(rules.rules_size(), 80);
  for (const rules::v1::Rule& rule : rules.rules()) {
    for (const std::string& field : rule.fields()) {
      const auto* pool = google::protobuf::DescriptorPool::generated_pool();
      EXPECT_NE(pool->FindFieldByName("flair.v1." + field), nullptr) << field;
    }
  }
}

TEST(ValidateRequests, PathsBeginWithTheField) {
  v1::SolveRequest request;
  *request.mutable_layout_graph() = GoodGraph();
  EXPECT_EQ(Text(Validate(request)), "");
  request.mutable_layout_graph()->mutable_edges(0)->set_weight(0);
  EXPECT_EQ(Text(Validate(request)), "layout_graph.edges[0].weight: 0 is outside (0, 100]");
  v1::CreateJobRequest job;
  job.mutable_spec()->mutable_brief()->set_text("A bedroom.");
  EXPECT_EQ(Text(Validate(job)), "request_id: is empty");
}

}  // namespace
}  // namespace flair
