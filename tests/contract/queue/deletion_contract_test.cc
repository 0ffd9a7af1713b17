// SPDX-License-Identifier: GPL-3.0-or-later
// What every form of a queue promises of jobs and batches that are forgotten.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/contract/queue/queue_test.h"

namespace flair::testing {
namespace {

using orchestrator::ArtifactStore;
using orchestrator::Deleted;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

FLAIR_EVERY_FORM(DeletionContract);

TEST_P(DeletionContract, AJobGoesWithWhatOnlyItHas) {
  WatchedQueue queue = Open();
  const std::string shared = RunAlone(queue, "job-1", {"shared", "own"}).front();
  RunAlone(queue, "job-2", {"shared"});
  EXPECT_TRUE(queue->FindResult("key-of-own").value().has_value());
  const auto deleted = queue->DeleteJob("job-1", *artifacts_);
  ASSERT_TRUE(deleted.ok()) << deleted.status();
  EXPECT_EQ(deleted->job_count, 1);
  EXPECT_EQ(deleted->artifact_count, 1);
  EXPECT_TRUE(deleted->done);
  EXPECT_TRUE(absl::IsNotFound(queue->GetJob("job-1").status()));
  EXPECT_THAT(*queue->EventsAfter("job-1", 0, 10), IsEmpty());
  EXPECT_EQ(queue->ListJobs({})->size(), 1);
  EXPECT_FALSE(queue->FindResult("key-of-own").value().has_value());
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("own")).status()));
  EXPECT_TRUE(queue->FindResult("key-of-shared").value().has_value());
  EXPECT_TRUE(artifacts_->Get(shared).ok());
  EXPECT_TRUE(absl::IsNotFound(queue->DeleteJob("job-1", *artifacts_).status()));
  // The last that has it.
  EXPECT_EQ(queue->DeleteJob("job-2", *artifacts_)->artifact_count, 1);
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(shared).status()));
}

TEST_P(DeletionContract, WhatAJobWasGivenIsThereBeforeItsFirstRunAndGoesWithTheLastThatHasIt) {
  WatchedQueue queue = Open();
  // It was there before, and went.
  RunAlone(queue, "job-0", {"given"});
  ASSERT_EQ(queue->DeleteJob("job-0", *artifacts_)->artifact_count, 1);
  orchestrator::GivenArtifact given{.artifact = Seal("given"), .record = {}, .store = artifacts_.get()};
  given.record.event.set_kind(v1::JOB_EVENT_KIND_STAGE_REUSED);
  given.record.event.set_stage("solve");
  *given.record.event.mutable_artifact() = given.artifact.ref;
  given.record.stage_index = 9;
  v1::Job of_ada = NewJob("job-1");
  of_ada.set_owner("ada");
  const auto made = queue->CreateJob(of_ada, "ada/r1", &given);
  ASSERT_TRUE(made.ok()) << made.status();
  EXPECT_THAT(made->artifacts(), ::testing::SizeIs(1));
  EXPECT_TRUE(artifacts_->Get(IdOf("given")).ok());
  EXPECT_TRUE(queue->OwnsArtifact("ada", IdOf("given")).value());
  EXPECT_FALSE(queue->OwnsArtifact("bob", IdOf("given")).value());
  ASSERT_THAT(*queue->EventsAfter("job-1", 0, 10), ::testing::SizeIs(1));
  // A repeat is the same job, and adds nothing to it.
  of_ada.set_id("job-9");
  orchestrator::GivenArtifact other = given;
  other.artifact = Seal("other");
  *other.record.event.mutable_artifact() = other.artifact.ref;
  const auto again = queue->CreateJob(of_ada, "ada/r1", &other);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->id(), "job-1");
  EXPECT_EQ(again->artifacts(0).id(), IdOf("given"));
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("other")).status()));
  for (int run = 0; run < 2; ++run) {
    // The first one dies.
    const auto lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_THAT(lease->job().artifacts(), ::testing::SizeIs(1));
    EXPECT_EQ(lease->taken().artifact_stages(0), 9);
    EXPECT_THAT(lease->history(), ::testing::SizeIs(1));
    EXPECT_EQ(lease->lost_run_count(), 0);
    if (run == 1) EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  ASSERT_TRUE(queue->CreateJob(NewJob("job-2"), "r2", &given).ok());
  EXPECT_EQ(queue->DeleteJob("job-1", *artifacts_)->artifact_count, 0);
  EXPECT_TRUE(artifacts_->Get(IdOf("given")).ok());
  ASSERT_TRUE(queue->Cancel("job-2", absl::FromUnixSeconds(1'800'000'100)).ok());
  EXPECT_EQ(queue->DeleteJob("job-2", *artifacts_)->artifact_count, 1);
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("given")).status()));
}

TEST_P(DeletionContract, WhatGoesOnStays) {
  WatchedQueue queue = Open();
  ASSERT_TRUE(queue->CreateJob(NewJob("job-1"), "r1").ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->DeleteJob("job-1", *artifacts_).status()));
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->DeleteJob("job-1", *artifacts_).status()));
  ASSERT_TRUE(queue->CreateBatch(NewBatch("b1")).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->DeleteBatch("b1", 100, *artifacts_).status()));
  ASSERT_TRUE(queue->AddJobs("b1", JobsOf("b1", 0, 2), true).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->DeleteBatch("b1", 100, *artifacts_).status()));
  EXPECT_EQ(queue->GetBatch("b1")->state(), v1::BATCH_STATE_ACTIVE);
  EXPECT_TRUE(absl::IsNotFound(queue->DeleteJob("job-9", *artifacts_).status()));
  EXPECT_TRUE(absl::IsNotFound(queue->DeleteBatch("b9", 100, *artifacts_).status()));
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
}

TEST_P(DeletionContract, AJobOfABatchGoesOnlyWithIt) {
  WatchedQueue queue = Open();
  RunBatch(queue, "b1", 1, {"own"});
  const auto deleted = queue->DeleteJob("b1-00000000", *artifacts_);
  EXPECT_TRUE(absl::IsFailedPrecondition(deleted.status()));
  EXPECT_THAT(deleted.status().message(), ::testing::HasSubstr("batch b1"));
}

TEST_P(DeletionContract, ItsRequestMayMakeAnotherJob) {
  WatchedQueue queue = Open();
  RunAlone(queue, "job-1", {"own"});
  ASSERT_TRUE(queue->DeleteJob("job-1", *artifacts_).ok());
  const auto again = queue->CreateJob(NewJob("job-2"), "request of job-1");
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(again->id(), "job-2");
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().id(), "job-2");
}

TEST_P(DeletionContract, ABatchGoesInSteps) {
  WatchedQueue queue = Open();
  RunBatch(queue, "b1", 450, {"own", "shared"});
  RunAlone(queue, "job-1", {"shared"});
  Deleted all;
  for (int step = 0; !all.done; ++step) {
    ASSERT_LT(step, 20);
    const auto some = queue->DeleteBatch("b1", 200, *artifacts_);
    ASSERT_TRUE(some.ok()) << some.status();
    all.job_count += some->job_count;
    all.artifact_count += some->artifact_count;
    all.done = some->done;
    if (!all.done) ExpectWhole(queue, "b1", 450 - all.job_count);
  }
  EXPECT_EQ(all.job_count, 450);
  EXPECT_EQ(all.artifact_count, 450);
  EXPECT_TRUE(absl::IsNotFound(queue->GetBatch("b1").status()));
  EXPECT_THAT(*queue->ListBatches({}), IsEmpty());
  EXPECT_THAT(*queue->EndsAfter("b1", 0, 10), IsEmpty());
  EXPECT_EQ(queue->ListJobs({})->size(), 1);
  EXPECT_TRUE(artifacts_->Get(IdOf("shared")).ok());
  EXPECT_TRUE(absl::IsNotFound(queue->DeleteBatch("b1", 100, *artifacts_).status()));
  // The same request makes another one.
  store::v1::BatchRecord again = NewBatch("b2");
  again.set_request_id(NewBatch("b1").request_id());
  EXPECT_EQ(queue->CreateBatch(again)->batch().id(), "b2");
}

TEST_P(DeletionContract, NothingOfABatchRunsAgainOnceItsDeletionHasBegun) {
  WatchedQueue queue = Open();
  RunBatch(queue, "b1", 300, {"own"}, v1::JOB_STATE_FAILED);
  ASSERT_FALSE(queue->DeleteBatch("b1", 200, *artifacts_)->done);
  EXPECT_FALSE(queue->Retry("b1-00000000").value());
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->SetBatchState("b1", v1::BATCH_STATE_ACTIVE)));
  EXPECT_TRUE(absl::IsFailedPrecondition(queue->AddJobs("b1", JobsOf("b1", 299, 1), true).status()));
  EXPECT_EQ(queue.TakeNow(), nullptr);
}

TEST_P(DeletionContract, ARunThatFoundWhatThenWasDeletedIsToldSo) {
  WatchedQueue queue = Open();
  RunAlone(queue, "job-1", {"own"});
  ASSERT_TRUE(queue->CreateJob(NewJob("job-2"), "r2").ok());
  auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  // It looks, and reads; then it goes.
  const auto found = queue->FindResult("key-of-own");
  ASSERT_TRUE(found.ok() && found->has_value());
  ASSERT_TRUE(artifacts_->Get((*found)->id()).ok());
  ASSERT_TRUE(queue->DeleteJob("job-1", *artifacts_).ok());
  orchestrator::StageRecord reused = Record(*lease, **found, "");
  reused.event.set_kind(v1::JOB_EVENT_KIND_STAGE_REUSED);
  EXPECT_TRUE(orchestrator::IsArtifactGone(lease->Record(reused)));
  EXPECT_FALSE(lease->lost());
  // The next run makes it.
  lease.reset();
  lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_FALSE(queue->FindResult("key-of-own").value().has_value());
  ASSERT_TRUE(Store(*lease, "own").ok());
  ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_TRUE(artifacts_->Get(IdOf("own")).ok());
  EXPECT_THAT(queue->GetJob("job-2")->artifacts(), ::testing::SizeIs(1));
}

TEST_P(DeletionContract, ARunThatStoredWhatThenWasDeletedEndsWithIt) {
  WatchedQueue queue = Open();
  RunAlone(queue, "job-1", {"own"});
  ASSERT_TRUE(queue->CreateJob(NewJob("job-2"), "r2").ok());
  auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  // It makes the same, and is slow to say so.
  orchestrator::SealedArtifact sealed = Seal("own");
  const orchestrator::StageRecord record = Record(*lease, sealed.ref, "key-of-own");
  ASSERT_TRUE(lease->Announce(std::span(&record, 1)).ok());
  ASSERT_TRUE(artifacts_->PutAll(std::span(&sealed, 1)).ok());
  ASSERT_TRUE(queue->DeleteJob("job-1", *artifacts_).ok());
  if (orchestrator::IsArtifactGone(lease->Record(record))) {
    lease.reset();
    lease = queue.Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(Store(*lease, "own").ok());
  }
  ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_TRUE(artifacts_->Get(sealed.ref.id()).ok());
  EXPECT_EQ(queue->DeleteJob("job-2", *artifacts_)->artifact_count, 1);
}

TEST_P(DeletionContract, WhatEndedLongAgoIsFound) {
  WatchedQueue queue = Open();
  RunAlone(queue, "job-1", {"own"});
  RunBatch(queue, "b1", 3, {"own"});
  ASSERT_TRUE(queue->CreateJob(NewJob("job-2"), "r2").ok());
  ASSERT_TRUE(queue->CreateBatch(NewBatch("b2")).ok());
  // EndAs ends at ...100.
  const auto early = queue->EndedBefore(absl::FromUnixSeconds(1'800'000'100), "", 100);
  ASSERT_TRUE(early.ok()) << early.status();
  EXPECT_THAT(early->job_ids, IsEmpty());
  EXPECT_THAT(early->batch_ids, IsEmpty());
  EXPECT_THAT(early->next, IsEmpty());
  const auto late = queue->EndedBefore(absl::FromUnixSeconds(1'800'000'101), "", 100);
  ASSERT_TRUE(late.ok());
  EXPECT_THAT(late->job_ids, ElementsAre("job-1"));
  EXPECT_THAT(late->batch_ids, ElementsAre("b1"));
  // In pages of one.
  std::vector<std::string> found;
  std::string next;
  for (int page = 0; page == 0 || !next.empty(); ++page) {
    ASSERT_LT(page, 10);
    const auto some = queue->EndedBefore(absl::FromUnixSeconds(1'800'000'101), next, 1);
    ASSERT_TRUE(some.ok());
    found.insert(found.end(), some->batch_ids.begin(), some->batch_ids.end());
    next = some->next;
  }
  EXPECT_THAT(found, ElementsAre("b1"));
}

TEST_P(DeletionContract, SeveralMayDeleteTheSameAtOnce) {
  WatchedQueue queue = Open();
  RunBatch(queue, "b1", 250, {"own", "shared"});
  RunAlone(queue, "job-1", {"shared"});
  std::atomic<int> failures = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) {
    threads.emplace_back([&, this] {
      WatchedQueue own = Open();
      for (bool done = false; !done;) {
        const auto some = own->DeleteBatch("b1", 100, *artifacts_);
        done = absl::IsNotFound(some.status()) || (some.ok() && some->done);
        if (!some.ok() && !done) ++failures;
        if (!some.ok() && !done) ADD_FAILURE() << some.status();
        if (!some.ok()) break;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
  EXPECT_TRUE(absl::IsNotFound(queue->GetBatch("b1").status()));
  EXPECT_TRUE(artifacts_->Get(IdOf("shared")).ok());
  EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("own-of-b1-00000007")).status()));
}

// A store whose calls that delete fail from one of them on.
class FailingStore final : public ArtifactStore {
 public:
  FailingStore(ArtifactStore& store, int calls) : store_(store), calls_(calls) {}
  absl::Status PutAll(std::span<const orchestrator::SealedArtifact> artifacts) override {
    return store_.PutAll(artifacts);
  }
  absl::StatusOr<v1::Artifact> Get(const std::string& id) override { return store_.Get(id); }
  absl::Status Flush(std::span<const v1::ArtifactRef> artifacts) override { return store_.Flush(artifacts); }
  absl::StatusOr<int64_t> Mark() override {
    if (--calls_ < 0) return absl::UnavailableError("no store");
    return store_.Mark();
  }
  absl::StatusOr<int64_t> Delete(std::span<const std::string> ids, int64_t mark) override {
    if (--calls_ < 0) return absl::UnavailableError("no store");
    return store_.Delete(ids, mark);
  }

 private:
  ArtifactStore& store_;
  int calls_;
};

TEST_P(DeletionContract, WhatAFailureLeftIsFinishedLater) {
  WatchedQueue queue = Open();
  for (int calls = 0; calls < 3; ++calls) {
    const std::string id = "job-" + std::to_string(calls);
    RunAlone(queue, id, {"own-of-" + id, "shared"});
    FailingStore failing(*artifacts_, calls);
    const auto deleted = queue->DeleteJob(id, failing);
    // Whatever came of it, nobody sees a job that is not whole.
    EXPECT_TRUE(absl::IsNotFound(queue->GetJob(id).status()));
    EXPECT_THAT(*queue->ListJobs({}), IsEmpty());
    ASSERT_TRUE(queue->FinishDeletions(*artifacts_).ok());
    EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("own-of-" + id)).status())) << deleted.status();
    EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf("shared")).status()));
  }
  EXPECT_EQ(queue->FinishDeletions(*artifacts_)->artifact_count, 0);
}

TEST_P(DeletionContract, AProcessThatIsKilledLeavesABatchThatIsWhole) {
  WatchedQueue queue = Open();
  RunBatch(queue, "b1", 450, {"own", "shared"});
  RunAlone(queue, "job-1", {"shared"});
  std::vector<std::string> arguments = form_->ChildArguments();
  arguments.emplace_back("b1");
  for (const char* step : {"step 0", "step 1", "step 2", "step 0", "step 1"}) {
    Process child(std::string(FLAIR_BINARY_DIR) + "/test_bin/flair_queue_child", arguments);
    // Killed while it works at the step, wherever it is.
    (void)child.WaitForLine(step);
    child.Signal(SIGKILL);
    const auto batch = queue->FindBatch("b1");
    if (absl::IsNotFound(batch.status())) break;
    ASSERT_TRUE(batch.ok()) << batch.status();
    ExpectWhole(queue, "b1", batch->job_count());
  }
  for (bool done = false; !done;) {
    const auto some = queue->DeleteBatch("b1", 1000, *artifacts_);
    ASSERT_TRUE(some.ok() || absl::IsNotFound(some.status())) << some.status();
    done = !some.ok() || some->done;
  }
  ASSERT_TRUE(queue->FinishDeletions(*artifacts_).ok());
  for (int64_t i = 0; i < 450; ++i) {
    const std::string own = "own-of-" + orchestrator::BatchJobId("b1", i);
    EXPECT_TRUE(absl::IsNotFound(artifacts_->Get(IdOf(own)).status())) << own;
  }
  EXPECT_TRUE(artifacts_->Get(IdOf("shared")).ok());
  EXPECT_THAT(*queue->ListBatches({}), IsEmpty());
}

}  // namespace
}  // namespace flair::testing
