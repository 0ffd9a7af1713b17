// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Columns, AreAsWideAsWhatIsInThemInCharacters) {
  Columns table({"name", ">size"});
  table.Add({"größe", "1"});
  table.Add({"a\nb", "22"});
  EXPECT_EQ(table.Text(10), "name   size\ngröße     1\na b      22\n");
  EXPECT_EQ(table.Text(1), "name   size\ngröße     1\n… 1 more; --all shows them\n");
  EXPECT_EQ(Shortened("größe", 5), "größe");
  EXPECT_EQ(Shortened("größer", 5), "größ…");
}

TEST(RoomText, TellsWallsOpeningsAndSize) {
  EXPECT_THAT(
      RoomText(testing::BedroomRoom()),
      AllOf(HasSubstr("4 m x 5 m, 3 m high, 20 m2"), ContainsRegex("south +\\(0, 0\\) +\\(4, 0\\) +4.00 +door_1"),
            ContainsRegex("door_1 +door +south +0.50 +0.90 +2.10 +hinge start, swing inward, opens 90°")));
}

TEST(ObjectsText, EqualPiecesShareARow) {
  v1::ObjectList list;
  for (const char* id : {"bed_1", "bed_2", "bed_3"}) *list.add_objects() = testing::BedroomBed(id);
  list.mutable_objects(1)->set_width_m(1.4);
  EXPECT_THAT(ObjectsText(list), AllOf(ContainsRegex("bed_1 … bed_3 +2 +bed +primary +floor +sleeping +1.60"),
                                       ContainsRegex("bed_2 +1 +bed +primary +floor +sleeping +1.40")));
}

TEST(GraphText, SetsSentencesBesideTheirCallsOrWhyThereIsNone) {
  v1::LayoutGraph graph = testing::BedroomGraph();
  v1::Sentence& lost = *graph.mutable_constraint_list()->add_sentences();
  lost = testing::BedroomSentence();
  lost.set_id("s2");
  lost.set_text("The bed floats.");
  v1::Diagnostic& why = *graph.add_diagnostics();
  why.set_subject_id("s2");
  why.set_message("beds do not float");
  EXPECT_THAT(GraphText(graph),
              AllOf(ContainsRegex("s1 +The bed's headboard is against a wall. +e1 +against_wall\\(object=bed\\)"),
                    ContainsRegex("s2 +The bed floats. +- +no call: beds do not float")));
}

TEST(CleanedText, ShowsTheWordsBeforeAndAfterWhereTheyAreKnown) {
  v1::ConstraintList raw, clean;
  for (const char* id : {"s1", "s2", "s3"}) {
    *raw.add_sentences() = testing::BedroomSentence();
    raw.mutable_sentences()->rbegin()->set_id(id);
    raw.mutable_sentences()->rbegin()->set_text("Words of " + std::string(id));
  }
  *clean.add_sentences() = raw.sentences(0);
  clean.mutable_sentences(0)->set_id("s4");
  clean.mutable_sentences(0)->set_text("Words of both");
  v1::CleaningStep& merged = *clean.add_cleaning_steps();
  merged.set_action(v1::CLEANING_ACTION_MERGED);
  merged.add_from_ids("s1");
  merged.add_from_ids("s2");
  merged.add_to_ids("s4");
  merged.set_reason("they say the same");
  v1::CleaningStep& dropped = *clean.add_cleaning_steps();
  dropped.set_action(v1::CLEANING_ACTION_CONTRADICTION_REMOVED);
  dropped.add_from_ids("s3");
  dropped.set_reason("it contradicts s4");
  const std::string text = CleanedText(clean, &raw);
  EXPECT_THAT(text,
              AllOf(HasSubstr("merged: they say the same\n  - s1  Words of s1\n  - s2  Words of s2\n  + s4  Words "
                              "of both\n"),
                    HasSubstr("contradiction removed: it contradicts s4\n  - s3  Words of s3\n")));
  EXPECT_THAT(CleanedText(clean, nullptr), AllOf(HasSubstr("not known"), HasSubstr("  - s1  \n")));
}

TEST(LayoutText, SortsWhatIsNotMetByWhatItCosts) {
  v1::SolvedLayout layout;
  *layout.mutable_graph() = testing::BedroomGraph();
  for (const auto& [id, cost, status] :
       {std::tuple{"e1", 0.1, v1::OUTCOME_STATUS_VIOLATED}, std::tuple{"e2", 0.7, v1::OUTCOME_STATUS_VIOLATED},
        std::tuple{"e3", 0.0, v1::OUTCOME_STATUS_DROPPED}, std::tuple{"e4", 0.0, v1::OUTCOME_STATUS_SATISFIED}}) {
    if (std::string(id) != "e1") *layout.mutable_graph()->add_edges() = testing::BedroomEdge();
    layout.mutable_graph()->mutable_edges()->rbegin()->set_id(id);
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_edge_id(id);
    outcome.set_weighted_cost(cost);
    outcome.set_status(status);
    outcome.set_reason("reason of " + std::string(id));
  }
  layout.add_placements()->set_object_id("bed");
  const std::string text = LayoutText(layout);
  EXPECT_LT(text.find("reason of e2"), text.find("reason of e1"));
  EXPECT_THAT(text, AllOf(HasSubstr("NOT MET, 2, dearest first"), HasSubstr("DROPPED, 1"), HasSubstr("reason of e3"),
                          Not(HasSubstr("reason of e4")), HasSubstr("1 hold, 2 missed, 1 dropped")));
}

TEST(CallText, WritesACallAsItIsRead) {
  v1::ConstraintEdge edge = testing::BedroomEdge();
  edge.set_weight(2.5);
  v1::Argument& sides = *edge.add_arguments();
  sides.set_name("sides");
  sides.mutable_value()->mutable_texts()->add_items("left");
  sides.mutable_value()->mutable_texts()->add_items("right");
  EXPECT_EQ(CallText(edge), "against_wall(object=bed, sides=[left, right]) x 2.5");
}

}  // namespace
}  // namespace flair::cli
