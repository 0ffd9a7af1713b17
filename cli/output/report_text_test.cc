// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/report_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flair::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

v1::LayoutMetrics Metrics(int asked, int met) {
  v1::LayoutMetrics metrics;
  metrics.set_use_count(asked);
  metrics.set_met_use_count(met);
  return metrics;
}

void Find(v1::FindingKind kind, const std::string& object_id, const std::string& message, v1::LayoutMetrics& metrics) {
  v1::Finding& finding = *metrics.add_findings();
  finding.set_kind(kind);
  finding.set_object_id(object_id);
  finding.set_message(message);
}

TEST(UsesInWords, CountsThem) {
  EXPECT_EQ(UsesInWords(Metrics(7, 7)), "All 7 uses are met.");
  EXPECT_EQ(UsesInWords(Metrics(7, 5)), "5 of 7 uses are met.");
  EXPECT_EQ(UsesInWords(Metrics(1, 1)), "The one use is met.");
  EXPECT_EQ(UsesInWords(Metrics(0, 0)), "");
}

TEST(WrongInWords, NamesTheFirstAndCountsTheRest) {
  v1::LayoutMetrics metrics;
  Find(v1::FINDING_KIND_OVERLAP, "rail", "the rail and the shower overlap by 0.10 m", metrics);
  Find(v1::FINDING_KIND_USE_NOT_MET, "chair", "the chair is 0.40 m from the desk, at most 0.10 m", metrics);
  EXPECT_THAT(WrongInWords(metrics, 5), ElementsAre("the rail and the shower overlap by 0.10 m",
                                                    "use not met: the chair is 0.40 m from the desk, at most 0.10 m"));
  EXPECT_THAT(WrongInWords(metrics, 1), ElementsAre("the rail and the shower overlap by 0.10 m", "and 1 more"));
}

// A rail near its shower, as asked; its call holds.
ArtifactsByKind RailNearShower(const v1::LayoutMetrics& metrics) {
  ArtifactsByKind artifacts;
  v1::ConstraintList& sentences =
      *artifacts[v1::ARTIFACT_KIND_COMPLETED_CONSTRAINT_LIST].mutable_completed_constraint_list();
  v1::Sentence& sentence = *sentences.add_sentences();
  sentence.set_id("s1");
  sentence.set_text("The rail hangs on the wall near the shower.");
  sentence.add_subject_ids("rail");
  v1::SolvedLayout& layout = *artifacts[v1::ARTIFACT_KIND_SOLVED_LAYOUT].mutable_solved_layout();
  layout.mutable_graph()->add_edges()->set_sentence_id("s1");
  layout.add_edge_outcomes()->set_status(v1::OUTCOME_STATUS_SATISFIED);
  *layout.mutable_metrics() = metrics;
  *artifacts[v1::ARTIFACT_KIND_REPORT].mutable_report()->mutable_metrics() = metrics;
  return artifacts;
}

TEST(WriteReport, GivesNoTickToWhatIsWhereItCannotBe) {
  EXPECT_THAT(WriteReport({}, RailNearShower({})), HasSubstr("| ✓ | The rail hangs on the wall near the shower. |"));
  v1::LayoutMetrics metrics = Metrics(3, 3);
  Find(v1::FINDING_KIND_OVERLAP, "rail", "the rail and the shower overlap by 0.10 m", metrics);
  const std::string report = WriteReport({}, RailNearShower(metrics));
  EXPECT_THAT(report, HasSubstr("| ✗ holds, but the rail and the shower overlap by 0.10 m | The rail hangs"));
  EXPECT_THAT(report, HasSubstr("## What is wrong\n\n- the rail and the shower overlap by 0.10 m\n"));
  EXPECT_THAT(report, HasSubstr("| uses met | 3 of 3 |"));
}

TEST(NotAsAsked, TellsEachWishOnceInTheWordsOfTheBrief) {
  v1::SolvedLayout layout;
  for (const char* id : {"s1", "s2"}) {
    v1::Sentence& sentence = *layout.mutable_graph()->mutable_constraint_list()->add_sentences();
    sentence.set_id(id);
    sentence.set_text("The pet bed is under the work table.");
    sentence.set_origin(v1::SENTENCE_ORIGIN_BRIEF);
    sentence.set_reason("the brief asks for \"cat baskets under the table\"");
    layout.mutable_graph()->add_edges()->set_sentence_id(id);
    v1::EdgeOutcome& outcome = *layout.add_edge_outcomes();
    outcome.set_status(v1::OUTCOME_STATUS_VIOLATED);
    outcome.set_reason("the pet bed is 1.10 m off the work table");
  }
  EXPECT_THAT(NotAsAsked(layout), ElementsAre("the brief asks for \"cat baskets under the table\"; the pet bed is "
                                              "1.10 m off the work table"));
}

TEST(WriteReport, SaysWhenNobodyMeasuredHeights) {
  EXPECT_THAT(WriteReport({}, RailNearShower({})), HasSubstr("| in three dimensions | not measured |"));
  v1::LayoutMetrics metrics;
  metrics.set_oob_3d_percent(0);
  metrics.set_oor_3d_percent(0.25);
  const std::string report = WriteReport({}, RailNearShower(metrics));
  EXPECT_THAT(report, HasSubstr("| in three dimensions | OOB 0.000 %, OOR 0.250 % |"));
  EXPECT_THAT(report, Not(HasSubstr("What is wrong")));
}

}  // namespace
}  // namespace flair::cli
