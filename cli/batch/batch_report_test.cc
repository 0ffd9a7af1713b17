// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch/batch_run.h"
#include "cli/batch/collector.h"
#include "cli/batch/results_file.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class BatchReportTest : public ::testing::Test {
 protected:
  BatchReportTest() : results_(*ResultsFile::Open(folder_ / "results.db")) {
    for (int i = 0; i < 10; ++i) {
      ResultRow row;
      row.Set("batch_index", int64_t{i});
      row.Set("line", int64_t{i + 1});
      row.Set("state", i < 7 ? "succeeded" : "failed");
      if (i < 7) row.Set("time_s", i + 1.0);
      if (i >= 7) row.Set("failure_kind", i == 7 ? "input" : "worker");
      if (i == 0) row.Set("key", "=1+1");
      if (i >= 7) row.Set("error", fmt::format("because of \"{}\",\nreally", i));
      EXPECT_TRUE(results_->Put(row).ok());
    }
  }
  testing::TestFolder folder_;
  std::unique_ptr<ResultsFile> results_;
};

TEST_F(BatchReportTest, CountsFailuresByKindWithAnExampleEach) {
  BatchReport report = *MakeBatchReport(*results_);
  EXPECT_EQ(report["succeeded_count"], 7);
  ASSERT_EQ(report["failures"].size(), 2u);
  EXPECT_EQ(report["failures"][0]["kind"], "worker");
  EXPECT_EQ(report["failures"][0]["count"], 2);
  EXPECT_EQ(report["failures"][0]["line"], 9);
  EXPECT_EQ(report["failures"][1]["error"], "because of \"7\",\nreally");
  EXPECT_THAT(BatchReportText(report),
              HasSubstr("10 jobs: 7 succeeded, 3 failed\n      2 worker, such as job 8 (line 9)"));
}

TEST_F(BatchReportTest, SaysHowFiguresAreSpread) {
  BatchReport report = *MakeBatchReport(*results_);
  ASSERT_EQ(report["columns"].size(), 1u);
  const auto& spread = report["columns"]["time_s"];
  EXPECT_EQ(spread["count"], 7);
  EXPECT_EQ(spread["mean"], 4);
  EXPECT_EQ(spread["p50"], 4);
  EXPECT_EQ(spread["p90"], 7);
  EXPECT_EQ(spread["most"], 7);
}

TEST_F(BatchReportTest, CsvHasTheColumnsAndQuotesWhatNeedsIt) {
  ASSERT_TRUE(WriteResultsCsv(*results_, folder_ / "a.csv").ok());
  const std::string csv = testing::ReadAll(folder_ / "a.csv");
  EXPECT_THAT(csv, StartsWith("batch_index,line,key,job_id,state,"));
  EXPECT_THAT(csv, HasSubstr("\r\n7,8,,,failed,input,,\"because of \"\"7\"\",\nreally\","));
  EXPECT_THAT(csv, HasSubstr("\r\n0,1,'=1+1,")) << "no formula";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.csv.partial"));
  EXPECT_FALSE(WriteResultsCsv(*results_, folder_ / "no" / "such" / "a.csv").ok());
}

TEST_F(BatchReportTest, OtherFilesAreNotTakenForResults) {
  testing::WriteAll(folder_ / "text.db", std::string(5000, 'x'));
  EXPECT_THAT(std::string(ResultsFile::Open(folder_ / "text.db").status().message()),
              HasSubstr("is not a database of flair batch"));
  EXPECT_EQ(ResultsFile::OpenToRead(folder_ / "none.db").status().code(), absl::StatusCode::kNotFound);
}

TEST(ResultColumns, AreAsTheDocumentationSays) {
  std::string table = "| column | what it holds |\n| --- | --- |\n";
  // Neighbours of one meaning, such as the times of the stages, share a row.
  std::string names, meaning;
  for (const ResultColumn& column : ResultColumns()) {
    if (column.meaning != meaning && !names.empty()) table += fmt::format("| {} | {} |\n", names, meaning);
    names = column.meaning == meaning ? names + ", `" + column.name + "`" : "`" + column.name + "`";
    meaning = column.meaning;
  }
  table += fmt::format("| {} | {} |\n", names, meaning);
  EXPECT_THAT(testing::ReadAll(FLAIR_SOURCE_DIR "/docs/batches.md"), ::testing::EndsWith("## Columns\n\n" + table));
}

TEST(ResultsFile, AChangeHappensWholeOrNotAtAll) {
  const auto results = *ResultsFile::OpenTemporary();
  const absl::Status status = results->Change([&]() -> absl::Status {
    EXPECT_TRUE(results->SetState("a", "1").ok());
    return absl::UnavailableError("no");
  });
  EXPECT_EQ(status.message(), "no");
  EXPECT_EQ(*results->State("a"), "");
}

TEST(StandingText, SaysWhatMattersFirstAndFitsTheTerminal) {
  BatchStanding standing;
  standing.batch.set_job_count(1000);
  standing.batch.set_succeeded_count(400);
  standing.batch.set_failed_count(12);
  standing.batch.set_open_count(588);
  standing.batch.set_running_count(4);
  v1::FailureCount& failure = *standing.batch.add_failures();
  failure.set_kind(v1::FAILURE_KIND_WORKER);
  failure.set_job_count(12);
  standing.per_second = 4.9;
  standing.rejected_count = 3;
  EXPECT_EQ(StandingText(standing),
            "412/1000  41 %  4.90/s  2:00 left  4 running  failed: 12 worker  3 lines rejected");
  EXPECT_EQ(StandingText(standing, 15), "412/1000  41 % ");
  standing.batch.set_state(v1::BATCH_STATE_PAUSED);
  standing.submitting = true;
  EXPECT_THAT(StandingText(standing), StartsWith("412/1000+  paused  4.90/s  4 running"));
}

TEST(BatchRate, LooksAMinuteBack) {
  RateMeter rate(absl::Minutes(1));
  const absl::Time start = absl::FromUnixSeconds(1000);
  rate.Add("", start, 0);
  EXPECT_EQ(rate.PerSecond(""), std::nullopt);
  for (int second = 1; second <= 120; ++second)
    rate.Add("", start + absl::Seconds(second), second <= 60 ? 0 : second - 60);
  EXPECT_DOUBLE_EQ(rate.PerSecond("").value(), 1);
}

TEST(TimeLeftText, IsAsShortAsItCanBe) {
  EXPECT_EQ(TimeLeftText(absl::Seconds(48)), "0:48");
  EXPECT_EQ(TimeLeftText(absl::Seconds(7510)), "2:05:10");
  EXPECT_EQ(TimeLeftText(absl::Hours(80)), "3 days");
}

TEST(KeptFiles, TakesWordsInAnyOrderAndNamesThoseThatThereAre) {
  EXPECT_EQ(KeptFiles::Parse("report, layout.pb,plan")->Words(), KeptFiles::Parse(KeptFiles::kDefault)->Words());
  EXPECT_TRUE(KeptFiles::Parse("none")->empty());
  EXPECT_THAT(std::string(KeptFiles::Parse("layuot").status().message()),
              HasSubstr("--keep: layuot: no such file (did you mean layout?); one of brief, brief.json, "));
}

TEST(KeptFiles, PicturesOfOneViewHaveNamesOfTheirOwn) {
  std::vector<v1::Artifact> artifacts(2);
  for (v1::Artifact& artifact : artifacts) {
    artifact.mutable_preview()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
    artifact.mutable_preview()->set_format(v1::PREVIEW_FORMAT_EXR);
  }
  artifacts[1].mutable_preview()->mutable_annotations();
  std::vector<std::string> names;
  for (const OutputFile& file : KeptFiles::Parse("pictures")->FilesOf({}, artifacts)) names.push_back(file.name);
  EXPECT_THAT(names, ::testing::ElementsAre("job.json", "birdseye.exr", "birdseye_2.exr", "birdseye_2.exr.json"));
}

}  // namespace
}  // namespace flair::cli
