// SPDX-License-Identifier: GPL-3.0-or-later
// What every form of a queue promises of jobs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/contract/queue/queue_test.h"

namespace flair::testing {
namespace {

using orchestrator::Lease;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class JobsContract : public QueueTest {};
FLAIR_EVERY_FORM(JobsContract);

TEST_P(JobsContract, AJobIsTakenAsItWasAskedFor) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1", "a kitchen"), "r1").ok());
  EXPECT_EQ(queue->CountQueued().value(), 1);
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().id(), "job-1");
  EXPECT_EQ(lease->job().spec().brief().text(), "a kitchen");
  EXPECT_EQ(lease->job().attempt_count(), 1);
  EXPECT_EQ(lease->job().state(), v1::JOB_STATE_RUNNING);
  EXPECT_FALSE(lease->lost());
  EXPECT_EQ(queue->GetJob("job-1")->state(), v1::JOB_STATE_RUNNING);
  EXPECT_EQ(queue->CountQueued().value(), 0);
  EXPECT_EQ(queue.TakeNow(), nullptr);
}

TEST_P(JobsContract, ARequestMakesOneJobWhereverItIsRepeated) {
  WatchedQueue one = Open();
  WatchedQueue other = Open();
  ASSERT_TRUE(one->CreateJob(NewJob("job-1", "a kitchen"), "r1").ok());
  const auto again = other->CreateJob(NewJob("job-2", "a bedroom"), "r1");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->id(), "job-1");
  EXPECT_EQ(again->spec().brief().text(), "a kitchen");
  EXPECT_TRUE(absl::IsNotFound(one->GetJob("job-2").status()));
  const auto lease = other.Take();
  ASSERT_NE(lease, nullptr);
  ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_EQ(other.TakeNow(), nullptr);
}

TEST_P(JobsContract, OneOfManyTakesEachJob) {
  WatchedQueue one = Open();
  WatchedQueue other = Open();
  std::set<std::string> made;
  for (int i = 0; i < 20; ++i) {
    const std::string id = "job-" + std::to_string(100 + i);
    made.insert(id);
    ASSERT_TRUE(one->CreateJob(NewJob(id), "r" + id).ok());
  }
  std::vector<std::unique_ptr<Lease>> leases;
  std::set<std::string> taken;
  for (int i = 0; i < 20; ++i) {
    leases.push_back((i % 2 == 0 ? one : other).Take());
    ASSERT_NE(leases.back(), nullptr);
    taken.insert(leases.back()->job().id());
  }
  EXPECT_EQ(taken, made);
  for (const auto& lease : leases) EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_EQ(one.TakeNow(), nullptr);
}

TEST_P(JobsContract, AloneStandingJobsAreTakenOldestFirst) {
  WatchedQueue queue = Open();
  for (const char* id : {"job-1", "job-2", "job-3"}) ASSERT_TRUE(queue->CreateJob(NewJob(id), id).ok());
  std::vector<std::string> order;
  for (int i = 0; i < 3; ++i) {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    order.push_back(lease->job().id());
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  EXPECT_THAT(order, ElementsAre("job-1", "job-2", "job-3"));
}

TEST_P(JobsContract, WhatARunRecordsIsSeenByAll) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_THAT(lease->history(), IsEmpty());
  ASSERT_TRUE(lease->Record(StageMade(*lease, "solve", 8, 'b', "key-of-solve")).ok());
  ASSERT_TRUE(lease->Record(StageMade(*lease, "brief", 0, 'a')).ok());
  ASSERT_TRUE(lease->Record(StageMade(*lease, "solve", 8, 'c')).ok());
  const auto job = other->GetJob("job-1");
  ASSERT_TRUE(job.ok());
  ASSERT_THAT(job->artifacts(), SizeIs(2));
  EXPECT_EQ(job->artifacts(0).id(), ArtifactId('a'));
  EXPECT_EQ(job->artifacts(1).id(), ArtifactId('c'));
  EXPECT_EQ(job->stage(), "solve");
  const auto events = other->EventsAfter("job-1", 1, 10);
  ASSERT_TRUE(events.ok());
  ASSERT_THAT(*events, SizeIs(2));
  EXPECT_EQ(events->front().sequence(), 2);
  EXPECT_EQ(events->front().stage(), "brief");
  EXPECT_THAT(*other->EventsAfter("job-1", 0, 1), SizeIs(1));
  EXPECT_THAT(*other->EventsAfter("no-such-job", 0, 10), IsEmpty());
  const auto result = other->FindResult("key-of-solve");
  ASSERT_TRUE(result.ok() && result->has_value());
  EXPECT_EQ((*result)->id(), ArtifactId('b'));
  EXPECT_FALSE(other->FindResult("another-key")->has_value());
}

TEST_P(JobsContract, WhatAnotherProcessMadeIsFoundThoughItWasNotThereBefore) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  for (const char* key : {"key-of-solve", "key-of-room"}) {
    EXPECT_FALSE(queue->FindResult(key)->has_value());
    EXPECT_FALSE(other->FindResult(key)->has_value());
  }
  ASSERT_TRUE(lease->Record(StageMade(*lease, "solve", 8, 'a', "key-of-solve")).ok());
  EXPECT_TRUE(queue->FindResult("key-of-solve")->has_value());
  EXPECT_TRUE(other.WaitUntil([&] { return other->FindResult("key-of-solve")->has_value(); }));
}

TEST_P(JobsContract, StepsAreStoredTogetherAndTheLastWithTheEnd) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  ASSERT_TRUE(lease->RecordAll({}).ok());
  const std::vector<orchestrator::StageRecord> first = {StageMade(*lease, "brief", 0, 'a', "key-of-brief"),
                                                        StageMade(*lease, "room", 1, 'b', "key-of-room")};
  ASSERT_TRUE(lease->RecordAll(first).ok());
  EXPECT_EQ(queue->GetJob("job-1")->stage(), "room");
  orchestrator::JobEnd end;
  end.stage = "report";
  end.time = absl::FromUnixSeconds(1'800'000'100);
  end.records = {StageMade(*lease, "solve", 8, 'c', "key-of-solve")};
  ASSERT_TRUE(lease->End(end).ok());
  EXPECT_TRUE(absl::IsAborted(lease->RecordAll(first)));
  const auto job = queue->GetJob("job-1");
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(job->state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(job->stage(), "report");
  ASSERT_THAT(job->artifacts(), SizeIs(3));
  EXPECT_EQ(job->artifacts(2).id(), ArtifactId('c'));
  const auto events = queue->EventsAfter("job-1", 0, 10);
  ASSERT_THAT(*events, SizeIs(4));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(events->at(static_cast<size_t>(i)).sequence(), i + 1);
  EXPECT_EQ(events->at(2).stage(), "solve");
  EXPECT_EQ(events->at(3).kind(), v1::JOB_EVENT_KIND_ENDED);
  for (const char* key : {"key-of-brief", "key-of-room", "key-of-solve"}) {
    const auto result = queue->FindResult(key);
    EXPECT_TRUE(result.ok() && result->has_value()) << key;
  }
}

TEST_P(JobsContract, AJobEndsOnce) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_INFEASIBLE).ok());
  EXPECT_TRUE(absl::IsAborted(EndAs(*lease, v1::JOB_STATE_SUCCEEDED)));
  EXPECT_TRUE(absl::IsAborted(lease->Record(StageMade(*lease, "brief", 0, 'a'))));
  const auto job = queue->GetJob("job-1");
  ASSERT_TRUE(job.ok());
  EXPECT_EQ(job->state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(job->failure_kind(), v1::FAILURE_KIND_INFEASIBLE);
  EXPECT_EQ(job->error(), "stage \"solve\": out of wood");
  EXPECT_EQ(job->error_code(), 13);
  EXPECT_EQ(job->end_time().seconds(), 1'800'000'100);
  const auto events = queue->EventsAfter("job-1", 0, 10);
  ASSERT_THAT(*events, SizeIs(1));
  EXPECT_EQ(events->front().kind(), v1::JOB_EVENT_KIND_ENDED);
  EXPECT_EQ(events->front().state(), v1::JOB_STATE_FAILED);
}

TEST_P(JobsContract, ALeaseThatIsDroppedLetsItsJobWaitAgain) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(lease->Record(StageMade(*lease, "brief", 0, 'a')).ok());
  }
  EXPECT_EQ(queue->GetJob("job-1")->state(), v1::JOB_STATE_QUEUED);
  const auto again = queue.Take();
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->job().attempt_count(), 2);
  EXPECT_THAT(again->history(), SizeIs(1));
  ASSERT_THAT(again->job().artifacts(), SizeIs(1));
}

TEST_P(JobsContract, AJobThatIsReturnedSaysWhyAndWaits) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(lease->Return(absl::Milliseconds(1500), "the optimizer is away").ok());
    EXPECT_TRUE(absl::IsAborted(EndAs(*lease, v1::JOB_STATE_SUCCEEDED)));
  }
  EXPECT_EQ(queue.TakeNow(), nullptr);
  const auto events = queue->EventsAfter("job-1", 0, 10);
  ASSERT_THAT(*events, SizeIs(1));
  EXPECT_EQ(events->front().kind(), v1::JOB_EVENT_KIND_WAITING);
  EXPECT_EQ(events->front().message(), "the optimizer is away");
  const auto again = queue.Take();
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->job().attempt_count(), 2);
}

TEST_P(JobsContract, AWaitingJobThatIsCancelledEndsAtOnce) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  ASSERT_TRUE(queue->Cancel("job-1", absl::FromUnixSeconds(1'800'000'200)).ok());
  const auto job = queue->GetJob("job-1");
  EXPECT_EQ(job->state(), v1::JOB_STATE_CANCELLED);
  EXPECT_EQ(job->end_time().seconds(), 1'800'000'200);
  EXPECT_EQ(queue.TakeNow(), nullptr);
  EXPECT_EQ(queue->CountQueued().value(), 0);
  EXPECT_TRUE(queue->Cancel("job-1", absl::FromUnixSeconds(1'800'000'300)).ok());
  EXPECT_EQ(queue->GetJob("job-1")->end_time().seconds(), 1'800'000'200);
  EXPECT_TRUE(absl::IsNotFound(queue->Cancel("no-such-job", absl::UnixEpoch())));
  EXPECT_TRUE(absl::IsNotFound(queue->Cancel("*", absl::UnixEpoch())));
}

TEST_P(JobsContract, ARunningJobIsCancelledFromAnotherProcess) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_FALSE(lease->cancel_requested());
  ASSERT_TRUE(other->Cancel("job-1", absl::UnixEpoch()).ok());
  EXPECT_TRUE(queue.WaitUntil([&] { return lease->cancellation().cancelled(); }));
  EXPECT_TRUE(lease->cancel_requested());
  EXPECT_FALSE(lease->lost());
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_CANCELLED).ok());
  EXPECT_EQ(other->GetJob("job-1")->state(), v1::JOB_STATE_CANCELLED);
}

TEST_P(JobsContract, ARunMayRecordAndEndAfterSomebodyWantedItsEnd) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  ASSERT_TRUE(queue->Cancel("job-1", absl::UnixEpoch()).ok());
  EXPECT_TRUE(lease->Record(StageMade(*lease, "brief", 0, 'a')).ok());
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_EQ(queue->GetJob("job-1")->state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_P(JobsContract, AJobOfAProcessThatIsKilledGoesOn) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  Process child(std::string(FLAIR_BINARY_DIR) + "/test_bin/flair_queue_child", form_->ChildArguments());
  ASSERT_EQ(child.WaitForLine("took "), "job-1");
  EXPECT_EQ(queue.TakeNow(), nullptr);
  child.Signal(SIGKILL);
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().attempt_count(), 2);
  EXPECT_THAT(lease->history(), SizeIs(1));
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
}

TEST_P(JobsContract, AJobOfABatchGoesOnWhenItsProcessIsKilled) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateBatch(NewBatch("b")).ok());
  ASSERT_TRUE(queue->AddJobs("b", JobsOf("b", 0, 1), true).ok());
  Process child(std::string(FLAIR_BINARY_DIR) + "/test_bin/flair_queue_child", form_->ChildArguments());
  ASSERT_EQ(child.WaitForLine("took "), "b-00000000");
  EXPECT_EQ(queue.TakeNow(), nullptr);
  child.Signal(SIGKILL);
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr) << "whoever has nothing to do is told";
  EXPECT_EQ(lease->job().attempt_count(), 2);
}

TEST_P(JobsContract, RunsCountAsLostInARowAndOnlyWhereNothingWasSaid) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  // An orchestrator that stops gives back what it runs.
  for (int i = 0; i < 3; ++i) {
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    EXPECT_EQ(lease->lost_run_count(), 0);
  }
  // One that is killed does not; what it stored before is progress.
  for (int killed = 1; killed <= 2; ++killed) {
    Process child(std::string(FLAIR_BINARY_DIR) + "/test_bin/flair_queue_child", form_->ChildArguments());
    ASSERT_EQ(child.WaitForLine("took "), "job-1");
    child.Signal(SIGKILL);
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    EXPECT_EQ(lease->lost_run_count(), 1);
    EXPECT_EQ(lease->job().attempt_count(), 3 + 2 * killed);
  }
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->lost_run_count(), 1);
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
}

TEST_P(JobsContract, AllOutlivesTheProcesses) {
  {
    WatchedQueue queue = Open();
    ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
    ASSERT_TRUE(queue->CreateJob(NewJob("job-2"), "r2").ok());
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  WatchedQueue queue = Open();
  EXPECT_EQ(queue->GetJob("job-1")->state(), v1::JOB_STATE_SUCCEEDED);
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().id(), "job-2");
}

TEST_P(JobsContract, JobsAreTakenByName) {
  WatchedQueue queue = Open();
  for (const char* id : {"job-1", "job-2"}) ASSERT_TRUE(queue->CreateJob(NewJob(id), id).ok());
  orchestrator::TakeFilter named;
  named.any = false;
  EXPECT_EQ(queue.TakeNow(named), nullptr);
  named.job_ids = {"job-2", "no-such-job"};
  {
    const auto lease = queue.Take(named);
    ASSERT_NE(lease, nullptr);
    EXPECT_EQ(lease->job().id(), "job-2");
    EXPECT_EQ(queue.TakeNow(named), nullptr);
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  const auto first = queue.Take();
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->job().id(), "job-1");
  ASSERT_TRUE(EndAs(*first, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_EQ(queue.TakeNow(), nullptr);
}

}  // namespace
}  // namespace flair::testing
