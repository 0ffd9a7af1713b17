// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "cli/batch/testing/fake_batch_service.h"
#include "cli/exit_code.h"
#include "tests/fixtures/programs.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

v1::Batch EndedBatch(int job_count) {
  v1::Batch batch;
  batch.set_id("b1");
  batch.set_label("rooms.jsonl");
  batch.set_job_count(job_count);
  batch.set_succeeded_count(job_count);
  return batch;
}

class BatchDeletionTest : public ::testing::Test {
 protected:
  absl::Status Delete(const v1::Batch& batch, const DeletionOptions& options = {.yes = true}) {
    ::testing::internal::CaptureStdout();
    Session session(service_.channel(), "the test");
    session.SetLimits({.patience = absl::ZeroDuration(), .stop = &stop_});
    absl::Status status = DeleteWholeBatch(batch, session, options);
    said_ = ::testing::internal::GetCapturedStdout();
    return status;
  }
  FakeBatchService service_;
  runtime::Cancellation stop_;
  std::string said_;
};

TEST_F(BatchDeletionTest, GoesOnUntilAllIsDoneAndSaysWhatWasFreed) {
  service_.SetDeletionSteps(3);
  ASSERT_TRUE(Delete(EndedBatch(30)).ok());
  EXPECT_EQ(said_, "deleted batch b1 (rooms.jsonl): 30 jobs, and 60 artifacts that no other job had\n");
  service_.SetDeletionSteps(1);
  ASSERT_TRUE(Delete(EndedBatch(10), {.yes = true, .json = true}).ok());
  EXPECT_THAT(said_, HasSubstr("\"10\""));
}

TEST(BatchFolder, IsNotWrittenThroughALink) {
  const testing::TestFolder folder;
  std::filesystem::create_symlink(folder / "elsewhere", folder / "results.db");
  const absl::Status status = BatchFolder::Hold(folder.path()).status();
  EXPECT_EQ(ExitCodeOf(status), kExitFiles);
  EXPECT_THAT(status.message(), HasSubstr("results.db: is a symbolic link"));
  EXPECT_FALSE(std::filesystem::exists(folder / "elsewhere"));
}

TEST_F(BatchDeletionTest, WhatGoesOnIsNotDeleted) {
  v1::Batch batch = EndedBatch(30);
  batch.set_open_count(2);
  const absl::Status running = Delete(batch);
  EXPECT_EQ(ExitCodeOf(running), kExitBadInput);
  EXPECT_THAT(running.message(),
              HasSubstr("2 of its jobs are waiting or running; end it first: flair batch cancel b1"));
  batch = EndedBatch(0);
  batch.set_open(true);
  EXPECT_THAT(Delete(batch).message(), HasSubstr("lines may still be added"));
}

TEST_F(BatchDeletionTest, WithoutATerminalItWantsAYes) {
  if (::isatty(0) != 0 && ::isatty(2) != 0) GTEST_SKIP() << "somebody could be asked";
  const absl::Status status = Delete(EndedBatch(30), {});
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_THAT(status.message(), HasSubstr("--yes: missing; this deletes 30 jobs of batch b1"));
}

}  // namespace
}  // namespace flair::cli
