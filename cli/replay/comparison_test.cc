// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/replay/comparison.h"

#include <gmock/gmock.h>

namespace flair::cli {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

// A job of three artifacts: brief, layout, preview, the report left out.
class ComparisonTest : public ::testing::Test {
 protected:
  void SetUp() override {
    job_.set_id("first");
    job_.mutable_spec()->mutable_brief()->set_text("A bedroom.");
    first_[v1::ARTIFACT_KIND_BRIEF].mutable_brief()->set_text("A bedroom.");
    v1::Artifact& layout = first_[v1::ARTIFACT_KIND_SOLVED_LAYOUT];
    layout.mutable_solved_layout()->add_placements()->set_x_m(1.2);
    layout.mutable_solved_layout()->mutable_graph()->set_catalog_library("ours");
    layout.mutable_producer()->set_build("a");
    first_[v1::ARTIFACT_KIND_PREVIEW].mutable_preview()->set_image("picture");
    first_[v1::ARTIFACT_KIND_PREVIEW].add_made_from_ids("of layout");
    for (auto& [kind, artifact] : first_) artifact.set_id(v1::ArtifactKind_Name(kind));
    replay_ = job_;
    replay_.mutable_spec()->mutable_replay()->set_job_id("first");
    again_ = first_;
  }
  v1::SolvedLayout& Layout() { return *again_[v1::ARTIFACT_KIND_SOLVED_LAYOUT].mutable_solved_layout(); }
  // As if the content had been stored: another content, another id.
  void Rename(v1::ArtifactKind kind) { again_[kind].set_id("another"); }
  std::vector<StageComparison> Compare() const { return CompareStages(job_, first_, replay_, again_); }
  std::string Table() const { return ComparisonTable(Compare()); }

  v1::Job job_;
  v1::Job replay_;
  ArtifactsByKind first_;
  ArtifactsByKind again_;
};

TEST_F(ComparisonTest, SaysThatAllAgrees) {
  EXPECT_TRUE(AllAgree(Compare()));
  EXPECT_THAT(Table(), HasSubstr("solve        agrees\n"));
  EXPECT_EQ(ComparisonSummary(Compare()), "3 stages agree");
}

TEST_F(ComparisonTest, NamesTheFirstFieldAndTheStageThatFollows) {
  Layout().mutable_placements(0)->set_x_m(1.24);
  Rename(v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  again_[v1::ARTIFACT_KIND_PREVIEW].mutable_preview()->set_image("pictures");
  Rename(v1::ARTIFACT_KIND_PREVIEW);
  EXPECT_FALSE(AllAgree(Compare()));
  EXPECT_THAT(Table(), HasSubstr("solve        differs           solved_layout.placements[0].x_m: 1.2 -> 1.24\n"));
  EXPECT_THAT(
      Table(),
      ContainsRegex("preview.image: \"7 bytes, [0-9a-f]*\" -> \"8 bytes, [0-9a-f]*\"; made from another solve\n"));
  EXPECT_EQ(ComparisonSummary(Compare()),
            "1 stage agrees, 2 differ, first \"solve\"; by the same program, build and configuration: it is not "
            "deterministic");
}

TEST_F(ComparisonTest, CallsAnotherBuildTheLikelyCause) {
  Layout().mutable_placements(0)->set_x_m(1.24);
  again_[v1::ARTIFACT_KIND_SOLVED_LAYOUT].mutable_producer()->set_build("b");
  Rename(v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  EXPECT_THAT(Table(), HasSubstr("producer.build: \"a\" -> \"b\"\n"));
  EXPECT_THAT(ComparisonSummary(Compare()), HasSubstr("likely because of producer.build: \"a\" -> \"b\""));
}

TEST_F(ComparisonTest, AnotherBuildWithTheSameContentAgrees) {
  again_[v1::ARTIFACT_KIND_SOLVED_LAYOUT].mutable_producer()->set_build("b");
  Rename(v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  EXPECT_TRUE(AllAgree(Compare()));
  EXPECT_THAT(Table(), HasSubstr("solve        same content\n"));
  EXPECT_EQ(ComparisonSummary(Compare()), "1 stage agrees, 2 agree in content only");
}

TEST_F(ComparisonTest, DifferencesThatWereAskedForAreNone) {
  replay_.mutable_spec()->mutable_solve_options()->set_max_restart_count(500);
  Layout().mutable_placements(0)->set_x_m(1.24);
  again_[v1::ARTIFACT_KIND_SOLVED_LAYOUT].set_options_digest("500");
  Rename(v1::ARTIFACT_KIND_SOLVED_LAYOUT);
  EXPECT_TRUE(AllAgree(Compare()));
  EXPECT_THAT(Table(), HasSubstr("solve        differs as asked  solved_layout.placements[0].x_m: 1.2 -> 1.24\n"));
  EXPECT_THAT(Table(), Not(HasSubstr("options_digest")));
  EXPECT_THAT(ComparisonSummary(Compare()), HasSubstr("1 differs as asked"));
  again_[v1::ARTIFACT_KIND_BRIEF].mutable_brief()->set_text("A kitchen.");
  EXPECT_FALSE(AllAgree(Compare()));
}

TEST_F(ComparisonTest, PutsTheGraphInALayoutLast) {
  Layout().mutable_graph()->set_catalog_library("theirs");
  Layout().set_total_cost(3);
  EXPECT_THAT(Table(), HasSubstr("solved_layout.total_cost: none -> 3\n"));
}

TEST_F(ComparisonTest, DoesNotCompareWhatWasTaken) {
  replay_.mutable_spec()->mutable_replay()->set_from_stage("render");
  EXPECT_THAT(Table(), HasSubstr("solve        taken\nrender       agrees\n"));
  EXPECT_EQ(ComparisonSummary(Compare()), "1 stage agrees, 2 taken");
}

TEST_F(ComparisonTest, SaysWhichStageIsMissing) {
  again_.erase(v1::ARTIFACT_KIND_PREVIEW);
  EXPECT_FALSE(AllAgree(Compare()));
  EXPECT_THAT(Table(), HasSubstr("render       missing now\n"));
  EXPECT_THAT(ComparisonSummary(Compare()), HasSubstr("1 differs, first \"render\""));
}

TEST_F(ComparisonTest, ComparesReportsByWhatEveryJobMayHave) {
  const auto add = [](ArtifactsByKind& artifacts, const std::string& job, double oob_percent) {
    v1::Artifact& artifact = artifacts[v1::ARTIFACT_KIND_REPORT];
    artifact.set_id("report of " + job);
    artifact.set_options_digest(job);
    artifact.mutable_report()->set_job_id(job);
    artifact.mutable_report()->mutable_metrics()->set_oob_percent(oob_percent);
  };
  add(first_, "first", 1);
  add(again_, "again", 1);
  EXPECT_THAT(Table(), HasSubstr("report       agrees\n"));
  add(again_, "again", 2);
  EXPECT_THAT(Table(), HasSubstr("report.metrics.oob_percent: 1 -> 2\n"));
}

TEST_F(ComparisonTest, ComparesPicturesByWhatIsDrawn) {
  const auto chunk = [](const std::string& type, const std::string& content) {
    return std::string(3, '\0') + static_cast<char>(content.size()) + type + content + "sum.";
  };
  const std::string begin = std::string("\x89PNG\r\n\x1a\n") + chunk("IHDR", "size");
  const auto set = [&](ArtifactsByKind& artifacts, const std::string& note, const std::string& drawing) {
    v1::Preview& preview = *artifacts[v1::ARTIFACT_KIND_PREVIEW].mutable_preview();
    preview.set_image(begin + chunk("tEXt", note) + chunk("IDAT", drawing) + chunk("IEND", ""));
  };
  set(first_, "made from layout 1", "bed");
  set(again_, "made from layout no. 2", "bed");
  Rename(v1::ARTIFACT_KIND_PREVIEW);
  EXPECT_THAT(Table(), HasSubstr("render       same content\n"));
  set(again_, "made from layout 1", "bad");
  EXPECT_THAT(Table(), HasSubstr("render       differs           preview.image: "));
  // A chunk that says that it is longer than the file.
  again_[v1::ARTIFACT_KIND_PREVIEW].mutable_preview()->mutable_image()->at(8) = '\x7f';
  EXPECT_THAT(Table(), HasSubstr("render       differs"));
}

TEST_F(ComparisonTest, TellsProgramsTheSame) {
  Layout().mutable_placements(0)->set_x_m(1.24);
  const std::string json = ComparisonJson(Compare(), "first", "again");
  EXPECT_THAT(json, HasSubstr("\"agrees\":false"));
  EXPECT_THAT(json, HasSubstr("\"path\":\"solved_layout.placements[0].x_m\""));
  EXPECT_THAT(json, Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace flair::cli
