// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "cli/diff/difference.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Two nightstands and a bed, placed, one call each, all held.
v1::Artifact Layout() {
  v1::Artifact artifact;
  v1::SolvedLayout& layout = *artifact.mutable_solved_layout();
  v1::LayoutGraph& graph = *layout.mutable_graph();
  *graph.mutable_room() = testing::BedroomRoom();
  *graph.mutable_zone_plan() = testing::BedroomZones();
  for (const char* id : {"bed", "nightstand_1", "nightstand_2"}) {
    v1::Object& object = *graph.mutable_object_list()->add_objects();
    object = testing::BedroomBed(id);
    object.set_name(std::string(id).substr(0, std::string(id).find('_')));
    v1::Sentence& sentence = *graph.mutable_constraint_list()->add_sentences();
    sentence = testing::BedroomSentence(id);
    sentence.set_id(std::string("s_") + id);
    sentence.set_text(std::string(id) + " is against a wall.");
    v1::ConstraintEdge& edge = *graph.add_edges();
    edge = testing::BedroomEdge(id);
    edge.set_id(std::string("e_") + id);
    edge.set_sentence_id(sentence.id());
    v1::Placement& place = *layout.add_placements();
    place.set_object_id(id);
    place.set_x_m(1.0 + layout.placements_size());
    place.set_y_m(1);
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_edge_id(edge.id());
    outcome.set_status(v1::OUTCOME_STATUS_SATISFIED);
  }
  layout.set_total_cost(2);
  return artifact;
}

Difference Compare(const v1::Artifact& a, const v1::Artifact& b) {
  absl::StatusOr<Difference> difference = CompareArtifacts(a, b);
  EXPECT_TRUE(difference.ok()) << difference.status();
  return *std::move(difference);
}

std::string TextOf(const v1::Artifact& a, const v1::Artifact& b) {
  return DifferenceText(Compare(a, b), "a.pb", "b.pb");
}

TEST(Diff, TheSameIsToldInOneLine) {
  EXPECT_EQ(TextOf(Layout(), Layout()), "a.pb and b.pb are the same solved layout\n");
}

TEST(Diff, LikeChangesOfLooksShareALineAndColoursAreNamed) {
  v1::Artifact a, b;
  for (const char* id : {"bed", "desk", "chair", "lamp"}) {
    v1::ObjectStyle& style = *a.mutable_style_sheet()->add_objects();
    style.set_subject_id(id);
    style.set_material("oak");
    style.mutable_colour()->set_name("honey");
    style.mutable_colour()->set_red(200);
    style.set_description(std::string("A plain ") + id + ".");
  }
  b = a;
  for (int i = 0; i < 3; ++i) {
    v1::ObjectStyle& style = *b.mutable_style_sheet()->mutable_objects(i);
    style.mutable_colour()->set_name("grey");
    style.mutable_colour()->set_red(90);
    style.set_description("Another one.");
  }
  EXPECT_THAT(TextOf(a, b), HasSubstr("  ~ bed, desk, chair  colour honey -> grey\n"));
  EXPECT_THAT(TextOf(a, b), Not(HasSubstr("red")));
}

TEST(Diff, AMoveIsADistanceADirectionAndATurn) {
  v1::Artifact b = Layout();
  v1::Placement& bed = *b.mutable_solved_layout()->mutable_placements(0);
  bed.set_x_m(bed.x_m() - 0.3);
  bed.set_y_m(bed.y_m() + 0.3);
  bed.set_theta_rad(3 * std::numbers::pi / 2);
  EXPECT_THAT(TextOf(Layout(), b), AllOf(HasSubstr("places      2 the same, 1 changed\n"),
                                         HasSubstr("  ~ bed  moved 0.42 m north-west, turned 90° right\n")));
  const Difference difference = Compare(Layout(), b);
  ASSERT_EQ(difference.fates.size(), 1u);
  EXPECT_EQ(difference.fates[0].a_id, "bed");
  const nlohmann::json json = nlohmann::json::parse(DifferenceJson(difference, "a", "b"));
  for (const nlohmann::json& section : json["sections"]) {
    if (section["title"] != "places") continue;
    EXPECT_NEAR(section["changes"][0]["detail"]["distance_m"].get<double>(), 0.4243, 1e-4);
    EXPECT_NEAR(section["changes"][0]["detail"]["turn_deg"].get<double>(), -90, 1e-9);
  }
}

TEST(Diff, MovesThatNobodySeesAreCountedNotListed) {
  v1::Artifact b = Layout();
  b.mutable_solved_layout()->mutable_placements(0)->set_x_m(2 + 1e-9);
  const Difference difference = Compare(Layout(), b);
  EXPECT_FALSE(difference.content_is_same);
  EXPECT_TRUE(difference.fates.empty());
  EXPECT_THAT(DifferenceText(difference, "a", "b"),
              HasSubstr("1 of them moved by less than 1 mm and 0.1°, 3 the same"));
}

TEST(Diff, ObjectsAddedRemovedAndResizedAreFatesOfThePicture) {
  v1::Artifact b = Layout();
  v1::SolvedLayout& layout = *b.mutable_solved_layout();
  v1::ObjectList& objects = *layout.mutable_graph()->mutable_object_list();
  objects.mutable_objects(0)->set_width_m(1.8);
  objects.mutable_objects(2)->set_id("lamp");
  objects.mutable_objects(2)->set_name("lamp");
  layout.mutable_placements(2)->set_object_id("lamp");
  const Difference difference = Compare(Layout(), b);
  EXPECT_THAT(
      DifferenceText(difference, "a", "b"),
      AllOf(HasSubstr("objects     1 the same, 1 added, 1 removed, 1 changed\n"), HasSubstr("  ~ bed"),
            HasSubstr("width 1.60 -> 1.80 m\n"), HasSubstr("  + lamp"), HasSubstr("  - nightstand_2 (nightstand)")));
  ASSERT_EQ(difference.fates.size(), 3u);
  EXPECT_EQ(difference.fates[0].words, "1.60 -> 1.80 m wide");
  EXPECT_EQ(difference.fates[1].b_id, "");
  EXPECT_EQ(difference.fates[2].a_id, "");
}

TEST(Diff, OtherNumbersOfTheSameSentencesAndCallsAreNoDifference) {
  v1::Artifact b = Layout();
  v1::LayoutGraph& graph = *b.mutable_solved_layout()->mutable_graph();
  for (int i = 0; i < graph.edges_size(); ++i) {
    graph.mutable_constraint_list()->mutable_sentences(i)->set_id("t" + std::to_string(i));
    graph.mutable_edges(i)->set_id("f" + std::to_string(i));
    graph.mutable_edges(i)->set_sentence_id("t" + std::to_string(i));
  }
  EXPECT_THAT(TextOf(Layout(), b), AllOf(HasSubstr("3 sentences, 3 calls"), Not(HasSubstr("~"))));
}

TEST(Diff, AChangedSentenceIsFoundByItsIdAndAChangedCallToldWhole) {
  v1::Artifact b = Layout();
  v1::LayoutGraph& graph = *b.mutable_solved_layout()->mutable_graph();
  graph.mutable_constraint_list()->mutable_sentences(0)->set_text("bed is in a corner.");
  graph.mutable_edges(0)->mutable_arguments(0)->mutable_value()->set_text("nightstand_1");
  EXPECT_THAT(
      TextOf(Layout(), b),
      AllOf(HasSubstr("  ~ s_bed bed is in a corner.  text \"bed is against a wall.\" -> \"bed is in a corner.\""),
            HasSubstr("against_wall(object=nightstand_1"), HasSubstr("was against_wall(object=bed")));
}

TEST(Diff, VerdictsAndCostsGoUpAndDown) {
  v1::Artifact b = Layout();
  v1::SolvedLayout& layout = *b.mutable_solved_layout();
  layout.set_total_cost(1);
  layout.mutable_metrics()->set_oob_percent(0.5);
  layout.mutable_edge_outcomes(1)->set_status(v1::OUTCOME_STATUS_VIOLATED);
  layout.mutable_edge_outcomes(1)->set_reason("missed by 0.20 m");
  EXPECT_THAT(TextOf(Layout(), b),
              AllOf(HasSubstr("verdicts    3 of 3 hold -> 2 of 3, 2 the same, 1 worse\n"), HasSubstr("before: holds"),
                    HasSubstr("  < total  2.000 -> 1.000\n"), HasSubstr("  > OOB  0.00 -> 0.50 %\n")));
  EXPECT_THAT(TextOf(b, Layout()), AllOf(HasSubstr("  > total"), HasSubstr("  < OOB"), HasSubstr("1 better")));
}

TEST(Diff, RoomsOfAnotherKindCompareButNotTheirPlaces) {
  v1::Artifact b = Layout();
  v1::Room& room = *b.mutable_solved_layout()->mutable_graph()->mutable_room();
  for (v1::Point2& vertex : *room.mutable_floor()->mutable_vertices()) vertex.set_x_m(3 * vertex.x_m());
  b.mutable_solved_layout()->mutable_placements(0)->set_x_m(9);
  const Difference difference = Compare(Layout(), b);
  EXPECT_THAT(DifferenceText(difference, "a", "b"),
              AllOf(HasSubstr("not compared: the rooms are too different"),
                    HasSubstr("floor  4.00 x 5.00 m, 4 corners -> 12.00 x 5.00")));
  EXPECT_TRUE(difference.fates.empty());
}

TEST(Diff, AnOpeningThatMovedIsNamed) {
  v1::Artifact a, b;
  *a.mutable_room() = testing::BedroomRoom();
  *b.mutable_room() = testing::BedroomRoom();
  b.mutable_room()->mutable_openings(0)->set_offset_m(1.5);
  EXPECT_THAT(TextOf(a, b), HasSubstr("offset 0.50 -> 1.50 m\n"));
}

TEST(Diff, WhoMadeItIsToldApartFromWhatItIs) {
  v1::Artifact b = Layout();
  b.mutable_producer()->set_build("another");
  const Difference difference = Compare(Layout(), b);
  EXPECT_TRUE(difference.content_is_same);
  EXPECT_THAT(DifferenceText(difference, "a", "b"), AllOf(HasSubstr("the content is the same, byte for byte"),
                                                          HasSubstr("  ~ build  \"\" -> \"another\"\n")));
}

TEST(Diff, TwoKindsAreRefused) {
  v1::Artifact room;
  *room.mutable_room() = testing::BedroomRoom();
  EXPECT_EQ(CompareArtifacts(Layout(), room).status().message(),
            "the first is a solved layout, the second a room; give two of the same kind");
}

TEST(Diff, ConstraintsBeforeAndAfterCleaningGoTogether) {
  v1::Artifact raw, clean;
  *raw.mutable_raw_constraint_list()->add_sentences() = testing::BedroomSentence();
  *clean.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
  EXPECT_TRUE(Compare(raw, clean).content_is_same);
  clean.mutable_constraint_list()->add_cleaning_steps()->set_action(v1::CLEANING_ACTION_MERGED);
  EXPECT_THAT(TextOf(raw, clean), HasSubstr("cleaning steps  0 -> 1"));
}

TEST(Diff, AVariantThatSaysNothingOfItsStagesHasLostNone) {
  v1::Artifact a = Layout();
  a.mutable_solved_layout()->add_stage_outcomes()->set_stage("primary");
  v1::Artifact b = Layout();
  b.mutable_solved_layout()->set_total_cost(1);
  EXPECT_THAT(TextOf(a, b), Not(HasSubstr("stages")));
  b.mutable_solved_layout()->add_stage_outcomes()->set_stage("polish");
  EXPECT_THAT(TextOf(a, b), HasSubstr("stages of the solve 1 added, 1 removed\n"));
}

TEST(NumberWords, HaveDigitsEnoughToTellThemApart) {
  EXPECT_EQ(NumberWords("width_m", 1.6, 1.8), "1.60 -> 1.80 m");
  EXPECT_EQ(NumberWords("width_m", 1.6, 1.60004), "1.60000 -> 1.60004 m");
  EXPECT_EQ(NumberWords("swing_angle_rad", 0, std::numbers::pi), "0.0 -> 180.0°");
  EXPECT_EQ(NumberWords("reachable_floor_share", 1, 0.5), "100.0 -> 50.0 %");
}

TEST(MatchKeys, PairsEqualKeysInOrderThenTriesTheNextKey) {
  const Keys a = {{"x1", "x2", "y1", "z9"}, {"x", "x", "y", "z"}}, b = {{"y1", "x7", "x8", "x9"}, {"y", "x", "x", "x"}};
  std::vector<std::pair<int, int>> found;
  for (const Pair& pair : MatchKeys(a, b)) found.push_back({pair.a, pair.b});
  EXPECT_EQ(found, (std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 0}, {3, -1}, {-1, 3}}));
}

}  // namespace
}  // namespace flair::cli
