// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/batch/testing/fake_batch_service.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SubmissionTest : public ::testing::Test {
 protected:
  // A submission of these lines by a process of its own, as far as it comes.
  absl::Status Submit(const std::string& lines, int seed_count = 1) {
    testing::WriteAll(folder_ / "briefs", lines);
    const auto input = OpenBatchInput(folder_ / "briefs", folder_ / "copy", stop_);
    if (!input.ok()) return input.status();
    Session session(service_.channel(), "the test");
    session.SetLimits({.patience = absl::Minutes(2), .stop = &stop_});
    const auto results = *ResultsFile::Open(folder_ / "results.db");
    const Submission::Options options{
        .defaults = {}, .seed_count = seed_count, .folder = folder_.path(), .waits = [this](const std::string& why) {
          waits_.push_back(why);
        }};
    request_id_ = Submission::RequestId(*input, options, "");
    const absl::StatusOr<v1::Batch> batch = session.CreateBatch(request_id_, "briefs");
    if (!batch.ok()) return batch.status();
    Submission submission(session, *results, *input, options);
    const absl::Status status = submission.Run(*batch);
    rejected_count_ = submission.rejected_count();
    if (!status.ok()) fmt::print("{}\n", status.ToString());
    rows_.clear();
    (void)results->ForEach("", [this](const ResultRow& row) {
      rows_.push_back(fmt::format("{}:{}:{}", row.Int("line"), row.Text("key"), row.Text("text")));
      return absl::OkStatus();
    });
    return status;
  }

  std::vector<std::string> Texts() {
    std::vector<std::string> texts;
    for (const v1::JobSpec& spec : service_.specs()) {
      texts.push_back(fmt::format("{} {}", spec.brief().text(), spec.brief().seed()));
    }
    return texts;
  }

  testing::TestFolder folder_;
  FakeBatchService service_;
  runtime::Cancellation stop_;
  std::string request_id_;
  std::vector<std::string> waits_;
  std::vector<std::string> rows_;
  int64_t rejected_count_ = 0;
};

std::string ManyLines(int count) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += fmt::format("Room {}.\n", i);
  return lines;
}

TEST_F(SubmissionTest, BadLinesAreToldAndDoNotStopTheRest) {
  ASSERT_TRUE(Submit("One.\n\n{\"id\": \"b\", \"text\": 3}\n{\"id\": \"c\", \"text\": \"Two.\"}\n[]\nThree.").ok());
  EXPECT_THAT(Texts(), ElementsAre("One. 0", "Two. 0", "Three. 0"));
  EXPECT_FALSE(service_.open());
  EXPECT_THAT(rows_, ElementsAre("1::One.", "4:c:Two.", "6::Three."));
  EXPECT_EQ(rejected_count_, 2);
  const std::string rejected = testing::ReadAll(folder_ / "rejected.jsonl");
  const json first = json::parse(rejected.substr(0, rejected.find('\n')));
  EXPECT_EQ(first["line"], 3);
  EXPECT_THAT(first["reason"].get<std::string>(), HasSubstr("text"));
  EXPECT_EQ(first["text"], "{\"id\": \"b\", \"text\": 3}");
}

TEST_F(SubmissionTest, ABatchIsAFileAndItsOptions) {
  ASSERT_TRUE(Submit("One.").ok());
  const std::string one = request_id_;
  ASSERT_TRUE(Submit("One.").ok());
  EXPECT_EQ(request_id_, one);
  ASSERT_TRUE(Submit("One.\n").ok());
  EXPECT_NE(request_id_, one);
  (void)Submit("One.", 2);
  EXPECT_NE(request_id_, one);
  EXPECT_LE(one.size(), 128u);
}

TEST_F(SubmissionTest, GoesOnBehindTheLastPageThatItRemembers) {
  service_.FailAdds({grpc::Status::OK, grpc::Status(grpc::StatusCode::INTERNAL, "as if killed")});
  const std::string lines = "[]\n" + ManyLines(1200);
  EXPECT_EQ(Submit(lines).code(), absl::StatusCode::kInternal);
  ASSERT_TRUE(Submit(lines).ok());
  EXPECT_THAT(service_.adds(), ElementsAre(0, 500, 1000));
  EXPECT_EQ(service_.specs().size(), 1200u);
  EXPECT_EQ(rejected_count_, 1);
  EXPECT_EQ(rows_.size(), 1200u);
  EXPECT_EQ(rows_.back(), "1201::Room 1199.");
  const std::string rejected = testing::ReadAll(folder_ / "rejected.jsonl");
  EXPECT_EQ(std::ranges::count(rejected, '\n'), 1);
}

TEST_F(SubmissionTest, WhatTheBatchHasIsNotSentAgain) {
  ASSERT_TRUE(Submit(ManyLines(1200)).ok());
  std::filesystem::remove(folder_ / "results.db");
  ASSERT_TRUE(Submit(ManyLines(1200)).ok());
  EXPECT_THAT(service_.adds(), ElementsAre(0, 500, 1000, 1000));  // the last one says again that nothing follows
  EXPECT_EQ(rows_.size(), 1200u);
}

TEST_F(SubmissionTest, WaitsWhileTheQueueIsFull) {
  service_.FailAdds({{grpc::StatusCode::RESOURCE_EXHAUSTED, "7 jobs wait"}});
  ASSERT_TRUE(Submit("One.").ok());
  EXPECT_THAT(waits_, ElementsAre("7 jobs wait"));
  EXPECT_THAT(Texts(), ElementsAre("One. 0"));
}

TEST_F(SubmissionTest, WhatTheOrchestratorRefusesIsRejectedAlone) {
  service_.Refuse("Two.");
  ASSERT_TRUE(Submit("One.\nTwo.\nThree.\n").ok());
  EXPECT_THAT(Texts(), ElementsAre("One. 0", "Three. 0"));
  EXPECT_THAT(rows_, ElementsAre("1::One.", "3::Three."));
  EXPECT_FALSE(service_.open());
  EXPECT_THAT(testing::ReadAll(folder_ / "rejected.jsonl"), HasSubstr("{\"line\":2,\"reason\":\"specs[0]: refused\""));
}

TEST_F(SubmissionTest, ABriefCanHaveManySeeds) {
  ASSERT_TRUE(
      Submit("One.\n{\"text\": \"Two.\", \"seed\": 7}\n{\"text\": \"No.\", \"seed\": 9007199254740991}", 2).ok());
  EXPECT_THAT(Texts(), ElementsAre("One. 0", "One. 1", "Two. 7", "Two. 8"));
  EXPECT_THAT(rows_, ElementsAre("1::One.", "1::One.", "2::Two.", "2::Two."));
  EXPECT_EQ(rejected_count_, 1);
}

TEST_F(SubmissionTest, FilesOfOtherKindsAreRefusedBeforeAnythingIsMade) {
  for (const std::string& bytes : {std::string(), std::string("\x89PNG\r\n\x1a\n"), std::string("\x1f\x8b\x08")}) {
    EXPECT_EQ(Submit(bytes).code(), absl::StatusCode::kInvalidArgument);
  }
  EXPECT_THAT(service_.request_ids(), ElementsAre());
}

}  // namespace
}  // namespace flair::cli
