// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/collector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch/testing/fake_batch_service.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CollectorTest : public ::testing::Test {
 protected:
  CollectorTest() : results_(*ResultsFile::Open(folder_ / "results.db")) {
    Session session(service_.channel(), "the test");
    session.SetLimits({.patience = absl::Minutes(2), .stop = &stop_});
    v1::AddToBatchRequest request;
    for (int i = 0; i < 10; ++i) request.add_specs()->mutable_brief()->set_text(fmt::format("Room {}.", i));
    (void)session.AddToBatch(request, [](const std::string&) {});
  }

  // A collector of its own.
  absl::Status Collect(const std::string& kept = KeptFiles::kDefault, int shard_size = 0) {
    Session session(service_.channel(), "the test");
    session.SetLimits({.patience = absl::ZeroDuration(), .stop = &stop_});
    std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder_.path());
    if (shard_size > 0) writer = *MakeTarShards(folder_.path(), shard_size);
    const Collector::Options options{
        .kept = *KeptFiles::Parse(kept), .fetch_count = 3, .keep_failed = shard_size == 0, .end_after = {}};
    Collector collector(session, *results_, *writer, options);
    absl::Status status = collector.Run("b1");
    fetched_count_ = collector.fetched_count();
    return status;
  }

  ResultRow Row(int64_t index) { return (*results_->Find(index)).value_or(ResultRow()); }
  std::string Job(int64_t index, const std::string& file) const {
    return testing::ReadAll(folder_ / fmt::format("jobs/000/00000{}/{}", index, file));
  }

  testing::TestFolder folder_;
  FakeBatchService service_;
  runtime::Cancellation stop_;
  std::unique_ptr<ResultsFile> results_;
  int64_t fetched_count_ = 0;
};

TEST_F(CollectorTest, EveryEndBecomesFilesAndARow) {
  service_.End(3);
  service_.End(1, "renderer worker at h:1: gone");
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(Job(3, "plan.png"), "picture 3");
  v1::Artifact layout;
  ASSERT_TRUE(layout.ParseFromString(Job(3, "layout.pb")));
  EXPECT_EQ(layout.solved_layout().total_cost(), 3);
  EXPECT_EQ(nlohmann::json::parse(Job(3, "report.json"))["report"]["job_id"], "j3");
  EXPECT_EQ(nlohmann::json::parse(Job(1, "job.json"))["error"], "renderer worker at h:1: gone");
  EXPECT_EQ(Row(3).Text("state"), "succeeded");
  EXPECT_EQ(std::get<double>(Row(3).Get("pathway_cost_m3")), 0.25);
  EXPECT_EQ(Row(3).Text("path"), "jobs/000/000003");
  EXPECT_EQ(Row(3).Text("layout_sha256").size(), 64u);
  EXPECT_EQ(Row(1).Text("failure_kind"), "worker");
  EXPECT_EQ(Row(1).Text("error"), "renderer worker at h:1: gone");
}

TEST_F(CollectorTest, AnotherCollectorGoesOnAndFetchesNothingTwice) {
  for (int i = 0; i < 5; ++i) service_.End(i);
  ASSERT_TRUE(Collect().ok());
  const int calls = service_.artifact_calls();
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(fetched_count_, 0);
  for (int i = 5; i < 10; ++i) service_.End(i);
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(fetched_count_, 5);
  EXPECT_EQ(service_.artifact_calls(), 2 * calls);
}

TEST_F(CollectorTest, AJobThatRanAgainReplacesItsFirstEnd) {
  service_.End(2, "gone");
  ASSERT_TRUE(Collect().ok());
  service_.End(2);
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(Row(2).Text("state"), "succeeded");
  EXPECT_EQ(Row(2).Text("error"), "");
  EXPECT_EQ(Row(2).Text("failure_kind"), "");
  EXPECT_EQ(Job(2, "plan.png"), "picture 2");
}

TEST_F(CollectorTest, GoesOnAfterAnErrorWithWhatIsMissing) {
  for (int i = 0; i < 10; ++i) service_.End(i);
  std::vector<grpc::Status> faults(8, grpc::Status::OK);
  faults.emplace_back(grpc::StatusCode::INTERNAL, "down");
  service_.FailArtifacts(faults);
  EXPECT_EQ(Collect().message(), "down");
  EXPECT_LT(*results_->Count("SELECT COUNT(*) FROM jobs"), 10);
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(*results_->Count("SELECT COUNT(*) FROM jobs WHERE state = 'succeeded' AND path IS NOT NULL"), 10);
  EXPECT_LT(service_.artifact_calls(), 2 * 30);
}

TEST_F(CollectorTest, AnArtifactThatIsGoneIsOneJobsFaultAndIsTriedAgain) {
  for (int i = 0; i < 3; ++i) service_.End(i);
  service_.FailArtifacts({grpc::Status(grpc::StatusCode::DATA_LOSS, "not what it was")});
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(*results_->Count("SELECT COUNT(*) FROM jobs WHERE fetch_error = 'not what it was'"), 1);
  EXPECT_EQ(*results_->Count("SELECT COUNT(*) FROM jobs WHERE path IS NOT NULL"), 2);
  ASSERT_TRUE(Collect().ok());
  EXPECT_EQ(fetched_count_, 1);
  EXPECT_EQ(*results_->Count("SELECT COUNT(*) FROM jobs WHERE fetch_error IS NULL AND path IS NOT NULL"), 3);
}

TEST_F(CollectorTest, RowsOfAShardAreRememberedWithTheShard) {
  for (int i = 0; i < 7; ++i) service_.End(i);
  service_.End(8, "gone");
  ASSERT_TRUE(Collect("layout", 4).ok());
  EXPECT_EQ(*results_->Count("SELECT COUNT(*) FROM jobs WHERE path = 'shards/shard-000000.tar'"), 4);
  EXPECT_EQ(*results_->Count("SELECT COUNT(*) FROM jobs WHERE path = 'shards/shard-000001.tar'"), 3);
  EXPECT_EQ(Row(8).Text("state"), "failed");
  EXPECT_EQ(Row(8).Text("path"), "");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "shards/shard-000001.tar"));
}

TEST_F(CollectorTest, NothingIsFetchedThatNobodyKeeps) {
  service_.End(0);
  ASSERT_TRUE(Collect("none").ok());
  EXPECT_EQ(service_.artifact_calls(), 1);  // the report, for the columns
  EXPECT_FALSE(std::filesystem::exists(folder_ / "jobs"));
}

TEST_F(CollectorTest, SaysWhereItCannotWrite) {
  service_.End(0);
  testing::WriteAll(folder_ / "jobs", "a file");
  const absl::Status status = Collect();
  EXPECT_EQ(status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(status.message()), HasSubstr("jobs/000"));
}

}  // namespace
}  // namespace flair::cli
