// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "orchestrator/batch/repeater.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/temporary_folder.h"
#include "spdlog/sinks/null_sink.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::SizeIs;

class SweeperTest : public ::testing::Test {
 protected:
  SweeperTest() : queue_(*SqliteWorkQueue::Open(folder_.path(), clock_)), artifacts_(folder_.path() + "/artifacts") {}

  v1::Job NewJob(const std::string& id) const {
    v1::Job job;
    job.set_id(id);
    job.set_state(v1::JOB_STATE_QUEUED);
    return job;
  }
  void EndNext() {
    const auto lease = queue_->Take({});
    ASSERT_TRUE(lease.ok() && *lease != nullptr);
    ASSERT_TRUE((*lease)->End({.state = v1::JOB_STATE_SUCCEEDED, .time = clock_.Now()}).ok());
  }
  void MakeAlone(const std::string& id) {
    ASSERT_TRUE(queue_->CreateJob(NewJob(id), "request of " + id).ok());
    EndNext();
  }
  // The last `running` of them go on.
  void MakeBatch(const std::string& id, int job_count, int running = 0) {
    store::v1::BatchRecord record;
    record.mutable_batch()->set_id(id);
    record.mutable_batch()->set_state(v1::BATCH_STATE_ACTIVE);
    record.mutable_batch()->set_open(true);
    record.set_request_id("request of " + id);
    ASSERT_TRUE(queue_->CreateBatch(record).ok());
    std::vector<v1::Job> jobs;
    for (int i = 0; i < job_count; ++i) {
      jobs.push_back(NewJob(BatchJobId(id, i)));
      jobs.back().set_batch_id(id);
      jobs.back().set_batch_index(i);
    }
    ASSERT_TRUE(queue_->AddJobs(id, jobs, true).ok());
    for (int i = running; i < job_count; ++i) EndNext();
  }
  // Steps until all has gone; how many there were.
  int Sweep(Sweeper& sweeper) {
    for (int steps = 1; steps < 100; ++steps) {
      const absl::StatusOr<Deleted> step = sweeper.Step();
      EXPECT_TRUE(step.ok()) << step.status();
      if (!step.ok() || step->done) return steps;
    }
    ADD_FAILURE() << "no end of it";
    return 0;
  }

  TemporaryFolder folder_;
  runtime::FakeClock clock_;
  const std::unique_ptr<WorkQueue> queue_;
  ArtifactFiles artifacts_;
  spdlog::logger logger_{"sweeper", std::make_shared<spdlog::sinks::null_sink_mt>()};
};

TEST_F(SweeperTest, WhatEndedGoesAfterItsTimeAndNotBefore) {
  Sweeper sweeper(*queue_, artifacts_, clock_, logger_, absl::Minutes(10));
  MakeAlone("job-1");
  clock_.Advance(absl::Minutes(5));
  MakeAlone("job-2");
  EXPECT_EQ(Sweep(sweeper), 1);
  EXPECT_THAT(*queue_->ListJobs({}), SizeIs(2));
  clock_.Advance(absl::Minutes(5) + absl::Seconds(1));
  Sweep(sweeper);
  EXPECT_TRUE(absl::IsNotFound(queue_->GetJob("job-1").status()));
  EXPECT_TRUE(queue_->GetJob("job-2").ok());
}

TEST_F(SweeperTest, ABatchGoesAsAWholeInSmallSteps) {
  Sweeper sweeper(*queue_, artifacts_, clock_, logger_, absl::Minutes(10));
  MakeBatch("b1", 900);
  clock_.Advance(absl::Minutes(11));
  EXPECT_GT(Sweep(sweeper), 2);
  EXPECT_TRUE(absl::IsNotFound(queue_->GetBatch("b1").status()));
}

TEST_F(SweeperTest, ABatchThatGoesOnStaysWithAllItsJobs) {
  Sweeper sweeper(*queue_, artifacts_, clock_, logger_, absl::Minutes(10));
  MakeBatch("b1", 3, 1);
  clock_.Advance(absl::Hours(100));
  Sweep(sweeper);
  EXPECT_EQ(queue_->GetBatch("b1")->job_count(), 3);
  // Ten minutes after its last job has ended.
  EndNext();
  Sweep(sweeper);
  EXPECT_EQ(queue_->GetBatch("b1")->succeeded_count(), 3);
  clock_.Advance(absl::Minutes(11));
  Sweep(sweeper);
  EXPECT_TRUE(absl::IsNotFound(queue_->GetBatch("b1").status()));
}

TEST_F(SweeperTest, ManyOfAllKindsGo) {
  for (int i = 0; i < 150; ++i) MakeAlone("job-" + std::to_string(i));
  for (int i = 0; i < 120; ++i) MakeBatch("b" + std::to_string(i), 2);
  clock_.Advance(absl::Minutes(11));
  Sweeper sweeper(*queue_, artifacts_, clock_, logger_, absl::Minutes(10));
  Sweep(sweeper);
  EXPECT_THAT(*queue_->ListJobs({.limit = 1000}), SizeIs(0));
  EXPECT_THAT(*queue_->ListBatches({.limit = 1000}), SizeIs(0));
}

TEST_F(SweeperTest, WithoutATimeAllStays) {
  Sweeper sweeper(*queue_, artifacts_, clock_, logger_, std::nullopt);
  MakeAlone("job-1");
  clock_.Advance(absl::Hours(100000));
  Sweep(sweeper);
  EXPECT_TRUE(queue_->GetJob("job-1").ok());
}

TEST_F(SweeperTest, SweepingByItselfEndsWhenToldTo) {
  Sweeper sweeper(*queue_, artifacts_, clock_, logger_, absl::Minutes(10));
  sweeper.Start();
  sweeper.Stop();
  sweeper.Stop();
}

}  // namespace
}  // namespace flair::orchestrator
