// SPDX-License-Identifier: GPL-3.0-or-later
// What every form of a queue tells of jobs, of whose they are, and of who works.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/contract/queue/queue_test.h"

namespace flair::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class ListingContract : public QueueTest {};
FLAIR_EVERY_FORM(ListingContract);

TEST_P(ListingContract, JobsAreListedNewestFirst) {
  WatchedQueue queue = Open();
  v1::Job of_ada = NewJob("20260101T000002000000-000001");
  of_ada.set_owner("ada");
  ASSERT_TRUE(queue->CreateJob(NewJob("20260101T000001000000-000001"), "r1").ok());
  ASSERT_TRUE(queue->CreateJob(of_ada, "r2").ok());
  ASSERT_TRUE(queue->CreateBatch(NewBatch("20260101T000003000000-000001")).ok());
  ASSERT_TRUE(queue->AddJobs("20260101T000003000000-000001", JobsOf("20260101T000003000000-000001", 0, 2), true).ok());
  ASSERT_TRUE(queue->CreateJob(NewJob("20260101T000004000000-000001"), "r4").ok());
  const auto ids = [&](const orchestrator::ListFilter& filter) {
    std::vector<std::string> found;
    const auto jobs = queue->ListJobs(filter);
    EXPECT_TRUE(jobs.ok()) << jobs.status();
    if (jobs.ok()) {
      for (const v1::Job& job : *jobs) found.push_back(job.id());
    }
    return found;
  };
  const std::string second = orchestrator::BatchJobId("20260101T000003000000-000001", 1);
  const std::string first = orchestrator::BatchJobId("20260101T000003000000-000001", 0);
  orchestrator::ListFilter filter;
  EXPECT_THAT(ids(filter), ElementsAre("20260101T000004000000-000001", second, first, "20260101T000002000000-000001",
                                       "20260101T000001000000-000001"));
  filter.limit = 2;
  EXPECT_THAT(ids(filter), ElementsAre("20260101T000004000000-000001", second));
  filter.before = second;
  EXPECT_THAT(ids(filter), ElementsAre(first, "20260101T000002000000-000001"));
  filter = {};
  filter.owner = "ada";
  EXPECT_THAT(ids(filter), ElementsAre("20260101T000002000000-000001"));
  filter = {};
  filter.batch_id = "20260101T000003000000-000001";
  EXPECT_THAT(ids(filter), ElementsAre(second, first));
  filter = {};
  filter.state = v1::JOB_STATE_RUNNING;
  EXPECT_THAT(ids(filter), IsEmpty());
}

TEST_P(ListingContract, WhoOwnsWhatIsKnown) {
  WatchedQueue queue = Open();
  v1::Job of_ada = NewJob("job-1");
  of_ada.set_owner("ada");
  v1::Job of_bob = NewJob("job-2");
  of_bob.set_owner("bob of the *.> \"team\"");
  ASSERT_TRUE(queue->CreateJob(of_ada, "r1").ok());
  ASSERT_TRUE(queue->CreateJob(of_bob, "r2").ok());
  EXPECT_EQ(queue->CountOpen("ada").value(), 1);
  EXPECT_EQ(queue->CountOpen(of_bob.owner()).value(), 1);
  EXPECT_EQ(queue->CountOpen("eve").value(), 0);
  const auto lease = queue.Take();
  ASSERT_NE(lease, nullptr);
  ASSERT_EQ(lease->job().owner(), "ada");
  EXPECT_EQ(queue->CountOpen("ada").value(), 1);
  ASSERT_TRUE(lease->Record(StageMade(*lease, "brief", 0, 'a')).ok());
  EXPECT_TRUE(queue->OwnsArtifact("ada", ArtifactId('a')).value());
  EXPECT_FALSE(queue->OwnsArtifact(of_bob.owner(), ArtifactId('a')).value());
  EXPECT_FALSE(queue->OwnsArtifact("ada", ArtifactId('b')).value());
  ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_TRUE(queue.WaitUntil([&] { return queue->CountOpen("ada").value() == 0; }));
  EXPECT_TRUE(queue->OwnsArtifact("ada", ArtifactId('a')).value());
}

TEST_P(ListingContract, OrchestratorsSayWhatTheyDo) {
  WatchedQueue queue = Open();
  WatchedQueue other = Open();
  v1::OrchestratorStatus status;
  status.set_id("one");
  status.set_host("here");
  status.set_running_count(3);
  *status.mutable_report_time() = google::protobuf::util::TimeUtil::GetCurrentTime();
  ASSERT_TRUE(queue->ReportStatus(status).ok());
  status.set_running_count(4);
  ASSERT_TRUE(queue->ReportStatus(status).ok());
  const auto known = other->Orchestrators();
  ASSERT_TRUE(known.ok());
  ASSERT_THAT(*known, SizeIs(1));
  EXPECT_EQ(known->front().running_count(), 4);
}

}  // namespace
}  // namespace flair::testing
