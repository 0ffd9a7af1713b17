// SPDX-License-Identifier: GPL-3.0-or-later
// How many jobs may wait: limits hold for calls made at once, and nobody is refused what is there already.
#include <gmock/gmock.h>

#include <atomic>
#include <thread>

#include "orchestrator/service/orchestrator_handlers.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/embedded_for_test.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/fake_workers.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {
namespace {

using ::testing::HasSubstr;
using Stub = v1::OrchestratorService::StubInterface;

class JobAdmissionTest : public ::testing::Test {
 protected:
  // Whether the job was added.
  bool Create(JobAdmission& admission, const Caller& caller, const std::string& id) {
    JobAdmission::Entry entry(admission, caller);
    const absl::Status granted = entry.Grant(1);
    EXPECT_TRUE(granted.ok() || absl::IsResourceExhausted(granted)) << granted;
    if (!granted.ok()) return false;
    v1::Job job;
    job.set_id(id);
    job.set_owner(caller.name);
    job.set_state(v1::JOB_STATE_QUEUED);
    return queue_->CreateJob(job, id).ok();
  }
  // Many threads, each of which adds what it can of ten jobs; how many were added.
  int CreateAtOnce(JobAdmission& admission, const Caller& caller) {
    std::atomic<int> created = 0;
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < 8; ++thread) {
      threads.emplace_back([&, thread] {
        for (int i = 0; i < 10; ++i) {
          created += Create(admission, caller, caller.name + std::to_string(thread) + "-" + std::to_string(i)) ? 1 : 0;
        }
      });
    }
    threads.clear();
    return created;
  }

  TemporaryFolder folder_;
  std::unique_ptr<WorkQueue> queue_ = *SqliteWorkQueue::Open(folder_.path(), runtime::SystemClock());
};

TEST_F(JobAdmissionTest, CallsMadeAtOnceGetExactlyWhatTheirCallerMayHave) {
  JobAdmission admission(*queue_, 1000);
  const Caller ada = {.name = "ada", .sees_all = false, .open_job_limit = 20};
  const Caller bob = {.name = "bob", .sees_all = false, .open_job_limit = 7};
  EXPECT_EQ(CreateAtOnce(admission, ada), 20);
  EXPECT_EQ(queue_->CountOpen("ada").value(), 20);
  EXPECT_EQ(CreateAtOnce(admission, bob), 7);
}

TEST_F(JobAdmissionTest, CallsMadeAtOnceDoNotOverfillTheQueue) {
  JobAdmission admission(*queue_, 20);
  const Caller anybody;
  int created = CreateAtOnce(admission, anybody);
  EXPECT_LE(created, 20);
  // Of what a call did not add, nothing stays kept from the others.
  while (Create(admission, anybody, "later-" + std::to_string(created))) ++created;
  EXPECT_EQ(created, 20);
}

TEST_F(JobAdmissionTest, ARefusedCallKeepsNothingFromOthers) {
  JobAdmission admission(*queue_, 20);
  const Caller anybody;
  JobAdmission::Entry big(admission, anybody);
  EXPECT_EQ(big.Grant(21).code(), absl::StatusCode::kResourceExhausted);
  EXPECT_EQ(JobAdmission::Entry(admission, anybody).Grant(20), absl::OkStatus());
  EXPECT_EQ(JobAdmission::Entry(admission, anybody).GrantSome(30).value(), 20);
}

// The queue takes two jobs, which nobody runs.
class FullQueueTest : public ::testing::Test {
 protected:
  FullQueueTest() {
    config_.set_store_path(folder_.path());
    config_.set_takes_no_jobs(true);
    config_.set_queued_job_limit(2);
    config_.mutable_runtime()->set_log_level("error");
  }
  static v1::CreateBatchRequest BatchRequest(const std::string& request_id, int count) {
    v1::CreateBatchRequest request;
    request.set_request_id(request_id);
    for (int i = 0; i < count; ++i) request.add_specs()->mutable_brief()->set_text("Room " + std::to_string(i));
    return request;
  }
  static v1::JobSpec Spec() {
    v1::JobSpec spec;
    spec.mutable_brief()->set_text("A bedroom.");
    return spec;
  }
  void Start() { orchestrator_ = std::make_unique<EmbeddedForTest>(config_, workers_.channels()); }

  TemporaryFolder folder_;
  config::v1::OrchestratorConfig config_;
  std::atomic<int> failures_ = 0;
  FakeStages stages_{[this](std::string_view rpc, runtime::CallContext&) -> absl::Status {
    if (rpc != "DescribeRoom" || failures_-- <= 0) return absl::OkStatus();
    return absl::InvalidArgumentError("brief.text: no room in it");
  }};
  FakeWorkers workers_{stages_};
  std::unique_ptr<EmbeddedForTest> orchestrator_;
};

TEST_F(FullQueueTest, ARepeatedJobIsReturned) {
  Start();
  const v1::Job first = *orchestrator_->CreateJob("r1", Spec());
  ASSERT_TRUE(orchestrator_->CreateJob("r2", Spec()).ok());
  const absl::Status third = orchestrator_->CreateJob("r3", Spec()).status();
  EXPECT_EQ(third.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(third.message()), HasSubstr("2 jobs are waiting; 1 more would exceed the limit of 2"));
  const auto again = orchestrator_->CreateJob("r1", Spec());
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->id(), first.id());
}

TEST_F(FullQueueTest, ARepeatedBatchAndItsPagesAreReturned) {
  Start();
  const auto batch = orchestrator_->Ask(&Stub::CreateBatch, BatchRequest("b1", 2));
  ASSERT_TRUE(batch.ok()) << batch.status();
  const auto again = orchestrator_->Ask(&Stub::CreateBatch, BatchRequest("b1", 2));
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->batch().id(), batch->batch().id());
  EXPECT_EQ(orchestrator_->Ask(&Stub::CreateBatch, BatchRequest("b2", 1)).status().code(),
            absl::StatusCode::kResourceExhausted);
  v1::AddToBatchRequest page;
  page.set_batch_id(batch->batch().id());
  *page.mutable_specs() = BatchRequest("", 2).specs();
  page.set_last(true);
  const auto added = orchestrator_->Ask(&Stub::AddToBatch, page);
  ASSERT_TRUE(added.ok()) << added.status();
  EXPECT_EQ(added->batch().job_count(), 2);
}

TEST_F(FullQueueTest, AsManyFailedJobsWaitAgainAsThereIsRoomFor) {
  config_.set_takes_no_jobs(false);
  failures_ = 5;
  Start();
  v1::CreateBatchRequest open = BatchRequest("b1", 0);
  open.set_open(true);
  const std::string id = orchestrator_->Ask(&Stub::CreateBatch, open)->batch().id();
  for (int i = 0; i < 5; ++i) {
    v1::AddToBatchRequest page;
    page.set_batch_id(id);
    page.set_first_index(i);
    *page.add_specs() = Spec();
    page.set_last(i == 4);
    ASSERT_TRUE(orchestrator_->Ask(&Stub::AddToBatch, page).ok());
    orchestrator_->Watch(orchestrator_->Ask(&Stub::ListJobs, v1::ListJobsRequest())->jobs(0).id());
  }
  orchestrator_ = nullptr;
  config_.set_takes_no_jobs(true);
  Start();
  v1::RetryBatchRequest retry;
  retry.set_batch_id(id);
  const absl::Status status = orchestrator_->Ask(&Stub::RetryBatch, retry).status();
  EXPECT_EQ(status.code(), absl::StatusCode::kResourceExhausted);
  EXPECT_THAT(std::string(status.message()), HasSubstr("2 of the failed jobs wait again"));
  v1::GetBatchRequest get;
  get.set_batch_id(id);
  EXPECT_EQ(orchestrator_->Ask(&Stub::GetBatch, get)->batch().failed_count(), 3);
}

}  // namespace
}  // namespace flair::orchestrator
