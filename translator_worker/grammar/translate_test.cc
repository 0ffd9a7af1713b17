// SPDX-License-Identifier: GPL-3.0-or-later
// What single sentences mean, case by case. Over 400 lines: two tables of cases, read from top to bottom.
#include "translator_worker/grammar/translate.h"

#include <string>
#include <vector>

#include "absl/strings/str_join.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "translator_worker/grammar/testing/labelled_rooms.h"
#include "translator_worker/grammar/testing/scorer.h"

namespace flair::translator {
namespace {

v1::TranslateRequest MakeRequest() {
  v1::TranslateRequest request;
  *request.mutable_catalog() =
      ReadCatalog(std::string(FLAIR_SOURCE_DIR) + "/translator_worker/grammar/testdata/catalog.textproto");
  const double corners[4][2] = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  for (const auto& corner : corners) {
    v1::Point2& vertex = *request.mutable_room()->mutable_floor()->add_vertices();
    vertex.set_x_m(corner[0]);
    vertex.set_y_m(corner[1]);
  }
  for (const char* name : {"south", "east", "north", "west"}) request.mutable_room()->add_walls()->set_name(name);
  request.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_DOOR);
  request.mutable_room()->add_openings()->set_kind(v1::OPENING_KIND_WINDOW);
  for (const char* zone : {"sleeping", "work", "dining"}) {
    v1::Zone& added = *request.mutable_zone_plan()->add_zones();
    added.set_id(zone);
    added.set_name(zone);
  }
  const auto add = [&](const char* id, const char* name, v1::ObjectKind kind, const char* zone, double width) {
    v1::Object& object = *request.mutable_object_list()->add_objects();
    object.set_id(id);
    object.set_name(name);
    object.set_kind(kind);
    object.set_zone_id(zone);
    object.set_width_m(width);
    object.set_depth_m(0.8);
    object.set_role(kind == v1::OBJECT_KIND_FLOOR ? v1::OBJECT_ROLE_SECONDARY : v1::OBJECT_ROLE_TERTIARY);
    object.set_walk_over(std::string(name) == "rug");
  };
  add("bed", "bed", v1::OBJECT_KIND_FLOOR, "sleeping", 0.7);
  add("nightstand_1", "nightstand", v1::OBJECT_KIND_FLOOR, "sleeping", 0.5);
  add("nightstand_2", "nightstand", v1::OBJECT_KIND_FLOOR, "sleeping", 0.5);
  add("desk", "desk", v1::OBJECT_KIND_FLOOR, "work", 1.2);
  add("desk_chair", "desk chair", v1::OBJECT_KIND_FLOOR, "work", 0.5);
  add("dining_table", "dining table", v1::OBJECT_KIND_FLOOR, "dining", 1.6);
  for (const char* id : {"dining_chair_1", "dining_chair_2", "dining_chair_3"}) {
    add(id, "dining chair", v1::OBJECT_KIND_FLOOR, "dining", 0.45);
  }
  add("sofa", "sofa", v1::OBJECT_KIND_FLOOR, "sleeping", 2);
  add("coffee_table", "coffee table", v1::OBJECT_KIND_FLOOR, "sleeping", 1);
  add("painting", "painting", v1::OBJECT_KIND_WALL, "", 1);
  add("table_lamp", "table lamp", v1::OBJECT_KIND_SURFACE, "", 0.3);
  add("pendant", "pendant", v1::OBJECT_KIND_CEILING, "", 0.4);
  add("rug", "rug", v1::OBJECT_KIND_FLOOR, "", 2);
  return request;
}

// Two doors, and a window in the north wall.
v1::TranslateRequest WithNamedOpenings(v1::TranslateRequest request) {
  request.mutable_room()->clear_openings();
  for (const auto& [id, wall] : {std::pair("door_1", "south"), {"door_2", "east"}, {"window_1", "north"}}) {
    v1::Opening& opening = *request.mutable_room()->add_openings();
    opening.set_id(id);
    opening.set_wall(wall);
    opening.set_kind(std::string(id).starts_with("door") ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW);
  }
  return request;
}

v1::LayoutGraph TranslateOne(const std::string& text, const std::vector<std::string>& subjects = {},
                             v1::SentenceScope scope = v1::SENTENCE_SCOPE_INTER) {
  v1::TranslateRequest request = MakeRequest();
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text(text);
  sentence.set_scope(scope);
  sentence.set_weight(2);
  for (const std::string& subject : subjects) sentence.add_subject_ids(subject);
  return Translate(request);
}

struct Case {
  std::string name;
  std::string sentence;
  std::vector<std::string> subjects;
  // One call a line.
  std::string calls;
};
std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.sentence; }

TEST(Openings, OneIsMeantByItsIdOrItsWall) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"The dining table is near door_2.", "close_to_feature(object=dining_table, feature=door_2)"},
      {"The dining table is near the east door.", "close_to_feature(object=dining_table, feature=door_2)"},
      {"The sofa faces door 1.", "faces_feature(object=sofa, feature=door_1)"},
      {"The desk is under the north window.", "under_window(object=desk, feature=window_1)"},
      {"The desk is under the window.", "under_window(object=desk)"},
      {"The desk does not block the east door.", "clear_of_feature(object=desk, feature=door_2)"},
      {"The desk is near a door.", "close_to_feature(object=desk, feature=door)"}};
  for (const auto& [text, call] : cases) {
    v1::TranslateRequest request = WithNamedOpenings(MakeRequest());
    v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
    sentence.set_id("s1");
    sentence.set_text(text);
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    const v1::LayoutGraph graph = Translate(request);
    ASSERT_EQ(graph.edges_size(), 1) << text << graph.DebugString();
    EXPECT_EQ(ToText(graph.edges(0)), call) << text;
  }
}

// A designer's "0.4 m in front" leaves room to be nearer; a person's does not.
TEST(Distances, ThatPeopleSayAreMeant) {
  v1::TranslateRequest request = MakeRequest();
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text("The coffee table is 0.4 m in front of the sofa.");
  sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
  sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
  EXPECT_EQ(ToText(Translate(request).edges(0)),
            "in_front_of(object=coffee_table, target=sofa, distance_m=0.4, min_distance_m=0.4)");
}

class Meaning : public testing::TestWithParam<Case> {};

TEST_P(Meaning, IsAsWritten) {
  const v1::LayoutGraph graph = TranslateOne(GetParam().sentence, GetParam().subjects);
  std::vector<std::string> calls;
  for (const v1::ConstraintEdge& edge : graph.edges()) calls.push_back(ToText(edge));
  EXPECT_EQ(absl::StrJoin(calls, "\n"), GetParam().calls) << graph.DebugString();
}

INSTANTIATE_TEST_SUITE_P(
    Walls, Meaning,
    testing::Values(
        Case{"HeadboardIsTheBack", "The bed's headboard is against a wall.", {}, "against_wall(object=bed, side=back)"},
        Case{"NamedWall", "The desk is against the north wall.", {}, "against_wall(object=desk, wall=north)"},
        Case{"LongestWall",
             "The sofa stands against the longest wall.",
             {},
             "against_wall(object=sofa, wall=south|north)"},
        Case{"Corner", "The desk is in a corner.", {}, "in_corner(object=desk)"},
        Case{"GapToWalls",
             "The sofa is at least 50 cm from the walls.",
             {},
             "not_against_wall(object=sofa, min_distance_m=0.5)"},
        Case{
            "ImplicitSubject", "Should be placed against a wall for stability.", {"desk"}, "against_wall(object=desk)"},
        Case{"FirstOfAlternatives", "Place it in a corner or against a wall.", {"desk"}, "in_corner(object=desk)"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Access, Meaning,
    testing::Values(Case{"LongSidesOfANarrowBed",
                         "Both long sides of the bed are accessible with 0.6 m of clearance.",
                         {},
                         "accessible(object=bed, sides=[\"left\",\"right\"], min_clearance_m=0.6)"},
                    Case{"LongSidesOfAWideTable",
                         "Both long sides of the dining table are accessible.",
                         {},
                         "accessible(object=dining_table, sides=[\"front\",\"back\"])"},
                    Case{"SpaceInFront",
                         "Leave half a metre of clear space in front of the desk.",
                         {},
                         "accessible(object=desk, sides=[\"front\"], min_clearance_m=0.5)"},
                    Case{"PulledOut",
                         "The desk chair should have enough space to pull out.",
                         {},
                         "accessible(object=desk_chair, sides=[\"back\"])"},
                    Case{"BehindThem",
                         "Leave at least 0.6 m behind each dining chair.",
                         {},
                         "accessible(object=dining_chair_1, sides=[\"back\"], min_clearance_m=0.6)\n"
                         "accessible(object=dining_chair_2, sides=[\"back\"], min_clearance_m=0.6)\n"
                         "accessible(object=dining_chair_3, sides=[\"back\"], min_clearance_m=0.6)"},
                    Case{"FrontAndSides",
                         "The desk is accessible from the front and sides.",
                         {},
                         "accessible(object=desk, sides=[\"front\",\"left\",\"right\"])"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Features, Meaning,
    testing::Values(Case{"DoorsAndWindows",
                         "The desk must not block doors or windows.",
                         {},
                         "clear_of_feature(object=desk, feature=door)\nclear_of_feature(object=desk, feature=window)"},
                    Case{"InFrontOfWindow",
                         "Avoid placing in front of windows.",
                         {"desk"},
                         "clear_of_feature(object=desk, feature=window)"},
                    Case{"NearWindow",
                         "The desk is within 1 m of a window.",
                         {},
                         "close_to_feature(object=desk, feature=window, max_distance_m=1.0)"},
                    Case{"UnderWindow", "The desk is under the window.", {}, "under_window(object=desk)"},
                    Case{"FacesDoor", "The sofa faces the door.", {}, "faces_feature(object=sofa, feature=door)"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Pairs, Meaning,
    testing::Values(
        Case{"InFront",
             "The coffee table is 0.4 m in front of the sofa.",
             {},
             "in_front_of(object=coffee_table, target=sofa, distance_m=0.4)"},
        Case{"Feet",
             "The desk is at least 2 ft away from the bed.",
             {},
             "away_from(object=desk, target=bed, min_distance_m=0.6096)"},
        Case{"Range",
             "The coffee table should be 0.3-1m from the sofa.",
             {},
             "away_from(object=coffee_table, target=sofa, min_distance_m=0.3)\n"
             "near(object=coffee_table, target=sofa, max_distance_m=1.0)"},
        Case{"SidesOfBoth",
             "The left side of the first nightstand is against the right side of the bed.",
             {},
             "next_to(object=nightstand_1, target=bed, object_side=left, target_side=right)"},
        Case{"OneOnEachSide",
             "The nightstands stand on each side of the bed.",
             {},
             "next_to(object=nightstand_1, target=bed, object_side=right, target_side=left)\n"
             "next_to(object=nightstand_2, target=bed, object_side=left, target_side=right)"},
        Case{"EachFaces",
             "Each dining chair faces the dining table.",
             {},
             "facing(object=dining_chair_1, target=dining_table)\nfacing(object=dining_chair_2, target=dining_table)\n"
             "facing(object=dining_chair_3, target=dining_table)"},
        Case{"TwoFacts",
             "The desk is against a wall and at least 1 m from the bed.",
             {},
             "against_wall(object=desk)\naway_from(object=desk, target=bed, min_distance_m=1.0)"},
        Case{"DistanceAfterRelation",
             "The front of the sofa should face the desk with at least 2 m between them.",
             {},
             "facing(object=sofa, target=desk)\naway_from(object=sofa, target=desk, min_distance_m=2.0)"},
        Case{"DeniedNearness",
             "The desk should not be within 0.5 m of the bed.",
             {},
             "away_from(object=desk, target=bed, min_distance_m=0.5)"},
        Case{"NearEachOther", "The desk and the bed are near each other.", {}, "near(object=bed, target=desk)"},
        Case{"OneOfSeveral",
             "One nightstand should be to the right of the bed.",
             {},
             "next_to(object=nightstand_1, target=bed, target_side=right)"},
        Case{"Synonym",
             "The couch is near the bedside tables.",
             {},
             "near(object=sofa, target=nightstand_1)\nnear(object=sofa, target=nightstand_2)"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Groups, Meaning,
    testing::Values(
        Case{"Surround",
             "The dining chairs surround the dining table.",
             {},
             "surround(center=dining_table, objects=[\"dining_chair_1\",\"dining_chair_2\",\"dining_chair_3\"])"},
        Case{"Row",
             "The desk, the sofa and the bed stand side by side in a row.",
             {},
             "row(objects=[\"desk\",\"sofa\",\"bed\"])"},
        Case{"Between",
             "The coffee table is between the sofa and the bed.",
             {},
             "between(object=coffee_table, first=sofa, second=bed)"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Tertiaries, Meaning,
    testing::Values(
        Case{"AboveBed",
             "The painting hangs on the wall above the bed.",
             {},
             "on_wall_above(object=painting, target=bed)"},
        Case{"OppositeBed",
             "The painting hangs on the wall opposite the bed.",
             {},
             "on_wall_facing(object=painting, target=bed)"},
        Case{"OnDesk", "The table lamp is on the desk.", {}, "on_top_center(object=table_lamp, host=desk)"},
        Case{"OnCorner",
             "The table lamp is on the back right corner of the desk.",
             {},
             "on_top_corner(object=table_lamp, host=desk, corner=back_right)"},
        Case{"Pendant",
             "The pendant hangs from the ceiling above the dining table.",
             {},
             "ceiling_above(object=pendant, target=dining_table)"},
        Case{"Rug", "The rug lies under the coffee table.", {}, "rug_under_center(rug=rug, object=coffee_table)"},
        Case{"RugPartly", "The rug is partly under the bed.", {}, "rug_under_forward(rug=rug, object=bed)"},
        Case{"WallOfZone",
             "The painting hangs on the wall of the work zone.",
             {},
             "on_wall_in_zone(object=painting, zone=work)"}),
    [](const auto& test) { return test.param.name; });

struct Refusal {
  std::string name;
  std::string sentence;
  std::string code;
};
std::ostream& operator<<(std::ostream& out, const Refusal& one) { return out << one.sentence; }

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithTheReasonAndTheSentence) {
  const v1::LayoutGraph graph = TranslateOne(GetParam().sentence);
  EXPECT_EQ(graph.edges_size(), 0) << graph.DebugString();
  ASSERT_GT(graph.diagnostics_size(), 0);
  EXPECT_EQ(graph.diagnostics(0).code(), GetParam().code) << graph.diagnostics(0).message();
  EXPECT_EQ(graph.diagnostics(0).subject_id(), "s1");
  EXPECT_THAT(graph.diagnostics(0).message(), testing::HasSubstr(GetParam().sentence));
}

INSTANTIATE_TEST_SUITE_P(
    Sentences, Refused,
    testing::Values(Refusal{"Nonsense", "Colourless green ideas sleep furiously.", "unknown_sentence"},
                    Refusal{"AbsentObject", "The desk is near the fireplace.", "names_absent_object"},
                    Refusal{"AbsentFeature", "The desk is near a socket.", "names_absent_feature"},
                    Refusal{"Condition", "The desk is against a wall if the room is small.", "conditional"},
                    Refusal{"UnknownDenial", "The sofa does not stand parallel to the bed.", "unknown_sentence"},
                    Refusal{"Paths", "Keep the walkways clear.", "not_about_layout"},
                    Refusal{"Light", "The desk needs good lighting.", "not_about_layout"},
                    Refusal{"Top", "The nightstand is accessible from the top.", "not_about_layout"},
                    Refusal{"Angle", "The sofa is at a 45-degree angle to the bed.", "not_expressible"}),
    [](const auto& test) { return test.param.name; });

TEST(Translate, HalvesTheWeightOfAWish) {
  EXPECT_EQ(TranslateOne("The desk is against a wall.").edges(0).weight(), 2);
  EXPECT_EQ(TranslateOne("Ideally, the desk is against a wall.").edges(0).weight(), 1);
}

TEST(Translate, SaysWhichPartOfASentenceWasLost) {
  const v1::LayoutGraph graph = TranslateOne("The desk should not block doors or pathways.");
  EXPECT_EQ(graph.edges_size(), 1);
  ASSERT_EQ(graph.diagnostics_size(), 1);
  EXPECT_EQ(graph.diagnostics(0).code(), "partial");
}

// Who sits at a desk looks over it, away from its front.
TEST(Translate, WhatADeskFacesIsWhatItsUserLooksAt) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"The desk should face the window.", "user_faces_feature(object=desk, feature=window)"},
      {"The desk is turned towards the door.", "user_faces_feature(object=desk, feature=door)"},
      {"The desk faces into the room.", "user_faces_room(object=desk)"},
      {"The desk faces the sofa.", "user_faces(object=desk, target=sofa)"},
      {"The desk does not face the bed.", "user_not_facing(object=desk, target=bed)"},
      {"The desk and the sofa face each other.",
       "user_faces(object=desk, target=sofa)\nfacing(object=sofa, target=desk)"},
      {"Whoever sits at the desk looks out of the window.", "user_faces_feature(object=desk, feature=window)"},
      {"Who works at the desk should look out of the window.", "user_faces_feature(object=desk, feature=window)"},
      {"Someone sitting on the sofa looks at the window.", "faces_feature(object=sofa, feature=window)"},
      {"From the sofa I want to look out of the window.", "faces_feature(object=sofa, feature=window)"},
      {"I want to see the door from the bed.", "faces_feature(object=bed, feature=door)"},
      {"The front of the desk faces the sofa.", "facing(object=desk, target=sofa)"},
      {"The desk is opposite the bed.", "facing(object=desk, target=bed)"},
      {"The sofa faces the desk.", "facing(object=sofa, target=desk)"}};
  for (const auto& [text, calls] : cases) {
    v1::TranslateRequest request = MakeRequest();
    for (v1::Object& object : *request.mutable_object_list()->mutable_objects())
      object.set_sat_at(object.id() == "desk");
    v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
    sentence.set_id("s1");
    sentence.set_text(text);
    sentence.set_scope(v1::SENTENCE_SCOPE_INTER);
    std::vector<std::string> lines;
    const v1::LayoutGraph graph = Translate(request);
    for (const v1::ConstraintEdge& edge : graph.edges()) lines.push_back(ToText(edge));
    EXPECT_EQ(absl::StrJoin(lines, "\n"), calls) << text;
  }
}

TEST(Translate, CallsOnlyWhatTheCatalogueHas) {
  v1::TranslateRequest request = MakeRequest();
  request.mutable_catalog()->clear_types();
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text("The desk is against a wall.");
  const v1::LayoutGraph graph = Translate(request);
  EXPECT_EQ(graph.edges_size(), 0);
  ASSERT_EQ(graph.diagnostics_size(), 1);
  EXPECT_EQ(graph.diagnostics(0).code(), "not_in_catalog");
}

TEST(Translate, FallsBackWhereTheCatalogueHasNoRow) {
  v1::TranslateRequest request = MakeRequest();
  auto& types = *request.mutable_catalog()->mutable_types();
  for (int i = types.size() - 1; i >= 0; --i) {
    if (types[i].name() == "row") types.DeleteSubrange(i, 1);
  }
  v1::Sentence& sentence = *request.mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text("The desk and the bed stand side by side.");
  const v1::LayoutGraph graph = Translate(request);
  ASSERT_EQ(graph.edges_size(), 1);
  EXPECT_EQ(graph.edges(0).type(), "next_to");
}

TEST(Translate, ClampsNumbersToTheirRangeAndSaysSo) {
  const v1::LayoutGraph graph = TranslateOne("The desk is at least 500 m away from the bed.");
  ASSERT_EQ(graph.edges_size(), 1);
  EXPECT_EQ(graph.edges(0).arguments(2).value().number(), 20);
  ASSERT_EQ(graph.diagnostics_size(), 1);
  EXPECT_EQ(graph.diagnostics(0).code(), "out_of_range");
}

}  // namespace
}  // namespace flair::translator
