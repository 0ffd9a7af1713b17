// SPDX-License-Identifier: GPL-3.0-or-later
// What every form of a queue promises of batches.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <thread>
#include <vector>

#include "tests/contract/queue/queue_test.h"

namespace flair::testing {
namespace {

using orchestrator::Lease;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class BatchesContract : public QueueTest {
 protected:
  // Makes a closed batch.
  void Make(WatchedQueue& queue, const std::string& id, int64_t jobs) {
    ASSERT_TRUE(queue->CreateBatch(NewBatch(id)).ok());
    const auto batch = queue->AddJobs(id, JobsOf(id, 0, jobs), true);
    ASSERT_TRUE(batch.ok()) << batch.status();
    ASSERT_EQ(batch->job_count(), jobs);
  }
  // The place in its batch of the job that was ended.
  int64_t EndNext(WatchedQueue& queue, v1::JobState state, v1::FailureKind kind = v1::FAILURE_KIND_UNSPECIFIED) {
    const auto lease = queue.Take();
    EXPECT_NE(lease, nullptr);
    if (lease == nullptr) return -1;
    EXPECT_TRUE(EndAs(*lease, state, kind).ok());
    return lease->job().batch_index();
  }
  static std::vector<std::string> Ids(const absl::StatusOr<std::vector<orchestrator::BatchEnd>>& ends) {
    std::vector<std::string> ids;
    EXPECT_TRUE(ends.ok()) << ends.status();
    if (ends.ok()) {
      for (const auto& end : *ends) ids.push_back(end.job_id);
    }
    return ids;
  }
};
FLAIR_EVERY_FORM(BatchesContract);

TEST_P(BatchesContract, ARequestMakesOneBatch) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  ASSERT_TRUE(queue->CreateBatch(NewBatch("b1")).ok());
  store::v1::BatchRecord repeated = NewBatch("b2");
  repeated.set_request_id(NewBatch("b1").request_id());
  const auto known = other->CreateBatch(repeated);
  ASSERT_TRUE(known.ok()) << known.status();
  EXPECT_EQ(known->batch().id(), "b1");
  EXPECT_EQ(known->specs_digest(), "digest of b1");
  EXPECT_TRUE(absl::IsNotFound(queue->GetBatch("b2").status()));
}

TEST_P(BatchesContract, WhetherARequestMadeSomethingIsKnownEverywhere) {
  using enum orchestrator::RequestKind;
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  store::v1::BatchRecord batch = NewBatch("b1");
  batch.mutable_batch()->set_owner("ada");
  batch.set_request_id("ada/r1");
  v1::Job job = NewJob("job-1");
  job.set_owner("ada");
  EXPECT_FALSE(queue->HasRequest(kBatch, "ada", "ada/r1").value());
  ASSERT_TRUE(queue->CreateBatch(batch).ok());
  EXPECT_TRUE(other->HasRequest(kBatch, "ada", "ada/r1").value());
  EXPECT_FALSE(other->HasRequest(kJob, "ada", "ada/r1").value());
  ASSERT_TRUE(queue->CreateJob(job, "ada/r2").ok());
  EXPECT_TRUE(other->HasRequest(kJob, "ada", "ada/r2").value());
  EXPECT_FALSE(other->HasRequest(kJob, "ada", "ada/r3").value());
}

TEST_P(BatchesContract, JobsAreAddedByPlace) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateBatch(NewBatch("b1")).ok());
  EXPECT_EQ(queue->AddJobs("b1", JobsOf("b1", 0, 3), false)->job_count(), 3);
  // Repeated, with more.
  EXPECT_EQ(queue->AddJobs("b1", JobsOf("b1", 1, 4), false)->job_count(), 5);
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->AddJobs("b1", JobsOf("b1", 6, 1), false).status()));
  const std::vector<v1::Job> others = {JobOf("b1", 2, "a castle")};
  EXPECT_TRUE(absl::IsAlreadyExists(queue->AddJobs("b1", others, false).status()));
  const auto closed = queue->AddJobs("b1", {}, true);
  ASSERT_TRUE(closed.ok());
  EXPECT_FALSE(closed->open());
  EXPECT_TRUE(queue->AddJobs("b1", JobsOf("b1", 0, 5), true).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->AddJobs("b1", JobsOf("b1", 5, 1), false).status()));
  EXPECT_TRUE(absl::IsNotFound(queue->AddJobs("b2", JobsOf("b2", 0, 1), false).status()));
  EXPECT_EQ(queue->CountQueued().value(), 5);
  const auto batch = queue->GetBatch("b1");
  ASSERT_TRUE(batch.ok());
  EXPECT_EQ(batch->job_count(), 5);
  EXPECT_EQ(batch->open_count(), 5);
  EXPECT_EQ(batch->label(), "briefs.jsonl");
}

TEST_P(BatchesContract, AThousandJobsAreAddedAtOnceAndEachIsTakenOnce) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 1000);
  std::map<std::string, int> taken;
  for (int i = 0; i < 1000; ++i) {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr) << i;
    ++taken[lease->job().id()];
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  EXPECT_THAT(taken, SizeIs(1000));
  EXPECT_EQ(queue->GetBatch("b1")->succeeded_count(), 1000);
  EXPECT_TRUE(queue->BatchHasEnded("b1").value());
  EXPECT_THAT(*queue->EndsAfter("b1", 0, 2000), SizeIs(1000));
}

TEST_P(BatchesContract, ManyThreadsOfAProcessTakeEachJobOnce) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 200);
  std::atomic<int> ended = 0;
  std::atomic<int> failed = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      // Once nothing is left, each waits for what does not come no longer than the others work.
      while (ended < 200 && failed == 0) {
        const auto lease = queue->Take({});
        if (!lease.ok()) ++failed;
        if (lease.ok() && *lease != nullptr && EndAs(**lease, v1::JOB_STATE_SUCCEEDED).ok()) ++ended;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(ended, 200);
  EXPECT_EQ(queue->GetBatch("b1")->succeeded_count(), 200);
}

TEST_P(BatchesContract, BatchesHaveTurnsAfterAloneStandingJobs) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 10);
  Make(queue, "b2", 10);
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  std::vector<std::unique_ptr<Lease>> leases;
  std::map<std::string, int> of_batch;
  for (int i = 0; i < 7; ++i) {
    leases.push_back(queue.Take());
    ASSERT_NE(leases.back(), nullptr);
    ++of_batch[leases.back()->job().batch_id()];
  }
  EXPECT_EQ(leases.front()->job().id(), "job-1");
  EXPECT_EQ(of_batch["b1"], 3);
  EXPECT_EQ(of_batch["b2"], 3);
  EXPECT_EQ(leases[1]->job().batch_index(), 0);
}

TEST_P(BatchesContract, APausedBatchWaitsAndLetsOthersPass) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  Make(queue, "b1", 3);
  Make(queue, "b2", 1);
  ASSERT_TRUE(other->SetBatchState("b1", v1::BATCH_STATE_PAUSED).ok());
  EXPECT_EQ(queue->GetBatch("b1")->state(), v1::BATCH_STATE_PAUSED);
  {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    EXPECT_EQ(lease->job().batch_id(), "b2");
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  EXPECT_EQ(queue.TakeNow(), nullptr);
  ASSERT_TRUE(other->SetBatchState("b1", v1::BATCH_STATE_ACTIVE).ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().batch_id(), "b1");
  EXPECT_TRUE(absl::IsNotFound(queue->SetBatchState("b3", v1::BATCH_STATE_PAUSED)));
}

TEST_P(BatchesContract, OnlyTheBatchesThatAreNamedAreTakenFrom) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 1);
  Make(queue, "b2", 1);
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  orchestrator::TakeFilter named;
  named.any = false;
  named.batch_ids = {"b2", "no-such-batch"};
  const auto lease = queue.Take(named);
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().batch_id(), "b2");
  EXPECT_EQ(queue.TakeNow(named), nullptr);
}

TEST_P(BatchesContract, ACancelledBatchEndsItsJobs) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  Make(queue, "b1", 4500);
  const auto running = queue.Take();
  ASSERT_NE(running, nullptr);
  ASSERT_TRUE(other->CancelBatch("b1", absl::FromUnixSeconds(1'800'000'200)).ok());
  EXPECT_TRUE(queue.WaitUntil([&] { return running->cancellation().cancelled(); }));
  EXPECT_TRUE(running->cancel_requested());
  EXPECT_FALSE(queue->BatchHasEnded("b1").value());
  EXPECT_EQ(queue->GetBatch("b1")->cancelled_count(), 4499);
  EXPECT_EQ(queue->GetBatch("b1")->open_count(), 1);
  ASSERT_TRUE(EndAs(*running, v1::JOB_STATE_CANCELLED).ok());
  EXPECT_EQ(queue->GetBatch("b1")->cancelled_count(), 4500);
  EXPECT_TRUE(queue->BatchHasEnded("b1").value());
  EXPECT_EQ(queue.TakeNow(), nullptr);
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->SetBatchState("b1", v1::BATCH_STATE_ACTIVE)));
  EXPECT_TRUE(queue->SetBatchState("b1", v1::BATCH_STATE_PAUSED).ok());
  EXPECT_EQ(queue->GetBatch("b1")->state(), v1::BATCH_STATE_CANCELLED);
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->AddJobs("b1", JobsOf("b1", 4500, 1), false).status()));
  EXPECT_TRUE(queue.WaitUntil([&] { return queue->CountQueued().value() == 0; }));
}

TEST_P(BatchesContract, JobsAreCountedByHowTheyEnd) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 7);
  EndNext(queue, v1::JOB_STATE_SUCCEEDED);
  const std::vector<int64_t> failed_places = {EndNext(queue, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_INPUT),
                                              EndNext(queue, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_INFEASIBLE),
                                              EndNext(queue, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_INFEASIBLE)};
  EndNext(queue, v1::JOB_STATE_CANCELLED);
  const auto running = queue.Take();
  ASSERT_NE(running, nullptr);
  EXPECT_TRUE(queue.WaitUntil([&] { return queue->GetBatch("b1")->running_count() == 1; }));
  const auto batch = queue->GetBatch("b1");
  ASSERT_TRUE(batch.ok()) << batch.status();
  EXPECT_EQ(batch->job_count(), 7);
  EXPECT_EQ(batch->succeeded_count(), 1);
  EXPECT_EQ(batch->failed_count(), 3);
  EXPECT_EQ(batch->cancelled_count(), 1);
  EXPECT_EQ(batch->open_count(), 2);
  ASSERT_THAT(batch->failures(), SizeIs(2));
  EXPECT_EQ(batch->failures(0).kind(), v1::FAILURE_KIND_INFEASIBLE);
  EXPECT_EQ(batch->failures(0).job_count(), 2);
  EXPECT_EQ(batch->failures(1).kind(), v1::FAILURE_KIND_INPUT);
  EXPECT_FALSE(queue->BatchHasEnded("b1").value());
  orchestrator::ListFilter failed;
  failed.batch_id = "b1";
  failed.state = v1::JOB_STATE_FAILED;
  const auto jobs = queue->ListJobs(failed);
  ASSERT_THAT(*jobs, SizeIs(3));
  EXPECT_EQ(jobs->front().batch_index(), std::ranges::max(failed_places));
}

TEST_P(BatchesContract, EndsComeInTheirOrder) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  Make(queue, "b1", 3);
  const auto first = queue.Take();
  const auto second = queue.Take();
  const auto third = other.Take();
  ASSERT_TRUE(first != nullptr && second != nullptr && third != nullptr);
  EXPECT_THAT(Ids(other->EndsAfter("b1", 0, 10)), IsEmpty());
  ASSERT_TRUE(EndAs(*second, v1::JOB_STATE_SUCCEEDED).ok());
  ASSERT_TRUE(EndAs(*first, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_WORKER).ok());
  EXPECT_THAT(Ids(other->EndsAfter("b1", 0, 10)), ElementsAre(second->job().id(), first->job().id()));
  EXPECT_THAT(Ids(other->EndsAfter("b1", 0, 1)), ElementsAre(second->job().id()));
  const int64_t seen = other->EndsAfter("b1", 0, 10)->back().sequence;
  EXPECT_THAT(Ids(other->EndsAfter("b1", seen, 10)), IsEmpty());
  ASSERT_TRUE(EndAs(*third, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_THAT(Ids(other->EndsAfter("b1", seen, 10)), ElementsAre(third->job().id()));
  EXPECT_THAT(Ids(other->EndsAfter("no-such-batch", 0, 10)), IsEmpty());
}

TEST_P(BatchesContract, AFailedJobIsRetriedWithWhatItHas) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 2);
  {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(lease->Record(StageMade(*lease, "brief", 0, 'a')).ok());
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_WORKER).ok());
  }
  EndNext(queue, v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(queue->BatchHasEnded("b1").value());
  const std::string failed = orchestrator::BatchJobId("b1", 0);
  const std::string succeeded = orchestrator::BatchJobId("b1", 1);
  EXPECT_FALSE(queue->Retry(succeeded).value());
  const auto retried = queue->Retry(failed);
  ASSERT_TRUE(retried.ok()) << retried.status();
  EXPECT_TRUE(*retried);
  EXPECT_FALSE(queue->Retry(failed).value());
  EXPECT_TRUE(absl::IsNotFound(queue->Retry("no-such-job").status()));
  EXPECT_FALSE(queue->BatchHasEnded("b1").value());
  EXPECT_EQ(queue->GetBatch("b1")->failed_count(), 0);
  EXPECT_THAT(Ids(queue->EndsAfter("b1", 0, 10)), ElementsAre(succeeded));
  EXPECT_EQ(queue->GetJob(failed)->state(), v1::JOB_STATE_QUEUED);
  EXPECT_EQ(queue->GetJob(failed)->error(), "");
  // The same failure again, and again a retry.
  {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    EXPECT_EQ(lease->job().id(), failed);
    EXPECT_THAT(lease->job().artifacts(), SizeIs(1));
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_WORKER).ok());
  }
  EXPECT_THAT(Ids(queue->EndsAfter("b1", 0, 10)), ElementsAre(succeeded, failed));
  EXPECT_TRUE(queue->Retry(failed).value());
  EndNext(queue, v1::JOB_STATE_SUCCEEDED);
  EXPECT_THAT(Ids(queue->EndsAfter("b1", 0, 10)), ElementsAre(succeeded, failed));
  EXPECT_EQ(queue->GetBatch("b1")->succeeded_count(), 2);
  const auto events = queue->EventsAfter(failed, 0, 100);
  EXPECT_EQ(std::ranges::count(*events, v1::JOB_EVENT_KIND_RETRIED, &v1::JobEvent::kind), 2);
  ASSERT_TRUE(queue->CancelBatch("b1", absl::UnixEpoch()).ok());
  EXPECT_EQ(queue->GetBatch("b1")->succeeded_count(), 2);
}

TEST_P(BatchesContract, FailedJobsOfACancelledBatchStayFailed) {
  WatchedQueue queue = Open();
  Make(queue, "b1", 2);
  EndNext(queue, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_TIMEOUT);
  ASSERT_TRUE(queue->CancelBatch("b1", absl::UnixEpoch()).ok());
  EXPECT_FALSE(queue->Retry(orchestrator::BatchJobId("b1", 0)).value());
  EXPECT_EQ(queue->GetBatch("b1")->failed_count(), 1);
  EXPECT_EQ(queue->GetBatch("b1")->cancelled_count(), 1);
}

TEST_P(BatchesContract, BatchesAreListedNewestFirst) {
  WatchedQueue queue = Open();
  for (const char* id : {"b1", "b2", "b3"}) {
    store::v1::BatchRecord record = NewBatch(id);
    record.mutable_batch()->set_owner(std::string(id) == "b2" ? "ada" : "");
    ASSERT_TRUE(queue->CreateBatch(record).ok());
  }
  const auto ids = [&](const orchestrator::ListFilter& filter) {
    std::vector<std::string> found;
    const auto batches = queue->ListBatches(filter);
    EXPECT_TRUE(batches.ok()) << batches.status();
    if (batches.ok()) {
      for (const v1::Batch& batch : *batches) found.push_back(batch.id());
    }
    return found;
  };
  orchestrator::ListFilter filter;
  EXPECT_THAT(ids(filter), ElementsAre("b3", "b2", "b1"));
  filter.limit = 1;
  filter.before = "b3";
  EXPECT_THAT(ids(filter), ElementsAre("b2"));
  filter = {};
  filter.owner = "ada";
  EXPECT_THAT(ids(filter), ElementsAre("b2"));
  filter.owner = "";
  EXPECT_THAT(ids(filter), ElementsAre("b3", "b1"));
}

TEST_P(BatchesContract, AnEmptyBatchThatIsClosedHasEnded) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateBatch(NewBatch("b1")).ok());
  EXPECT_FALSE(queue->BatchHasEnded("b1").value());
  ASSERT_TRUE(queue->AddJobs("b1", {}, true).ok());
  EXPECT_TRUE(queue->BatchHasEnded("b1").value());
  EXPECT_TRUE(absl::IsNotFound(queue->BatchHasEnded("b2").status()));
}

}  // namespace
}  // namespace flair::testing
