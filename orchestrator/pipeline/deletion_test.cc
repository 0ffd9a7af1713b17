// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of jobs while what they use is deleted, and runs that take their process with them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>

#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/store/job_store.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/temporary_folder.h"
#include "spdlog/sinks/null_sink.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

class RunsAndDeletion : public ::testing::Test {
 protected:
  RunsAndDeletion()
      : queue_(*SqliteWorkQueue::Open(folder_.path(), clock_)), artifacts_(folder_.path() + "/artifacts") {}

  static v1::Job BedroomJob(const std::string& id, const std::string& text = "A bedroom.") {
    v1::Job job;
    job.set_id(id);
    job.set_state(v1::JOB_STATE_QUEUED);
    job.mutable_spec()->mutable_brief()->set_text(text);
    return job;
  }
  // One job, whose steps are kept back while they are short.
  void MakeBatchOfOne(const std::string& id, const std::string& text = "A bedroom.") {
    store::v1::BatchRecord record;
    record.mutable_batch()->set_id(id);
    record.mutable_batch()->set_state(v1::BATCH_STATE_ACTIVE);
    record.mutable_batch()->set_open(true);
    record.set_request_id("request of " + id);
    ASSERT_TRUE(queue_->CreateBatch(record).ok());
    v1::Job job = BedroomJob(BatchJobId(id, 0), text);
    job.set_batch_id(id);
    ASSERT_TRUE(queue_->AddJobs(id, std::span(&job, 1), true).ok());
  }
  absl::Status RunNext(FakeStages& stages) {
    const auto lease = queue_->Take({});
    if (!lease.ok() || *lease == nullptr) return absl::NotFoundError("no job waits");
    const PipelineResult result = Pipeline(*queue_, artifacts_, stages, clock_, {}).Run(**lease);
    if (!result.status.ok()) return result.status;
    return (*lease)->End({.state = v1::JOB_STATE_SUCCEEDED, .stage = result.stage, .records = result.records});
  }

  TemporaryFolder folder_;
  runtime::FakeClock clock_;
  const std::unique_ptr<WorkQueue> queue_;
  ArtifactFiles artifacts_;
  spdlog::logger logger_{"runner", std::make_shared<spdlog::sinks::null_sink_mt>()};
};

TEST_F(RunsAndDeletion, WhatIsDeletedUnderARunIsMadeAgainByTheNext) {
  MakeBatchOfOne("b1");
  FakeStages first;
  ASSERT_TRUE(RunNext(first).ok());
  MakeBatchOfOne("b2");
  // The report is the only stage that it runs: the others are found. Before that is stored, they go.
  FakeStages second([&](std::string_view rpc, runtime::CallContext&) {
    if (rpc == "Evaluate") EXPECT_TRUE(queue_->DeleteBatch("b1", 100, artifacts_).ok());
    return absl::OkStatus();
  });
  EXPECT_TRUE(IsArtifactGone(RunNext(second)));
  EXPECT_EQ(second.calls("Solve"), 0);
  FakeStages third;
  EXPECT_TRUE(RunNext(third).ok());
  EXPECT_EQ(third.calls("Solve"), 1);
  const absl::StatusOr<v1::Job> job = queue_->GetJob("b2-00000000");
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(job->state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_GT(job->artifacts_size(), 8);
  for (const v1::ArtifactRef& ref : job->artifacts()) EXPECT_TRUE(artifacts_.Get(ref.id()).ok()) << ref.kind();
}

TEST_F(RunsAndDeletion, WhatAnotherJobHasOfTheSameBriefIsKept) {
  FakeStages stages;
  MakeBatchOfOne("b1");
  ASSERT_TRUE(RunNext(stages).ok());
  MakeBatchOfOne("b2", "  A bedroom.\n");
  ASSERT_TRUE(RunNext(stages).ok());
  ASSERT_TRUE(queue_->DeleteBatch("b1", 100, artifacts_).ok());
  const absl::StatusOr<v1::Job> job = queue_->GetJob("b2-00000000");
  ASSERT_TRUE(job.ok());
  EXPECT_GT(job->artifacts_size(), 8);
  for (const v1::ArtifactRef& ref : job->artifacts()) EXPECT_TRUE(artifacts_.Get(ref.id()).ok()) << ref.kind();
}

TEST_F(RunsAndDeletion, AJobThatTakesItsProcessWithItTwentyTimesIsNotBegunAgain) {
  ASSERT_TRUE(queue_->CreateJob(BedroomJob("job-1"), "r1").ok());
  const auto store = *JobStore::Open(folder_.path());
  for (int i = 0; i < 20; ++i) {
    store::v1::JobRecord record = *store->jobs().Load("job-1");
    BeginRun(record, "died");
    ASSERT_TRUE(store->jobs().Save(record, record.events_size()).ok());
    ASSERT_TRUE(store->jobs().Release("died").ok());
  }
  std::promise<void> ended;
  queue_->Listen({.changed = [&, told = false](const std::string& id) mutable {
    if (id == "job-1" && !std::exchange(told, true)) ended.set_value();
  }});
  FakeStages stages;
  const Pipeline pipeline(*queue_, artifacts_, stages, clock_, {});
  JobRunner runner(*queue_, pipeline, clock_, logger_, {});
  ended.get_future().wait();
  runner.Stop();
  queue_->Listen({});
  const absl::StatusOr<v1::Job> job = queue_->GetJob("job-1");
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(job->state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job->failure_kind(), v1::FAILURE_KIND_WORKER);
  EXPECT_THAT(job->error(), ::testing::HasSubstr("20 runs"));
  EXPECT_EQ(stages.all_calls(), 0);
}

}  // namespace
}  // namespace flair::orchestrator
