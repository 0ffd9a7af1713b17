// SPDX-License-Identifier: GPL-3.0-or-later
// What the queue on NATS servers does when servers, connections and processes fail between two steps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <map>
#include <nlohmann/json.hpp>

#include "orchestrator/jetstream/open.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "orchestrator/jetstream/streams.h"
#include "orchestrator/service/orchestrator_handlers.h"
#include "tests/contract/queue/queue_forms.h"
#include "tests/fixtures/nats_server.h"
#include "worker_runtime/clock/clock.h"

namespace flair::testing {
namespace {

using nlohmann::json;
using orchestrator::BatchJobId;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class JetStreamFailures : public ::testing::Test {
 protected:
  void Serve(int count, NatsOptions options = {}) {
    servers_ = std::make_unique<NatsServers>(count, std::move(options));
    ASSERT_TRUE(servers_->ok()) << servers_->Log();
    config_.set_address(servers_->address());
    config_.set_replica_count(count);
    config_.set_lease_seconds(1);
  }
  std::unique_ptr<WatchedQueue> Open() {
    auto queue = orchestrator::OpenJetStreamQueue(config_, nullptr, runtime::SystemClock());
    EXPECT_TRUE(queue.ok()) << queue.status();
    return queue.ok() ? std::make_unique<WatchedQueue>(*std::move(queue)) : nullptr;
  }
  void Make(WatchedQueue& queue, const std::string& id, int64_t jobs) {
    ASSERT_TRUE(queue->CreateBatch(NewBatch(id)).ok());
    const auto batch = queue->AddJobs(id, JobsOf(id, 0, jobs), true);
    ASSERT_TRUE(batch.ok()) << batch.status();
  }
  // What somebody else does to the servers.
  json Ask(const std::string& verb, const json& request) {
    auto connection = orchestrator::NatsConnection::Open(config_, nullptr);
    EXPECT_TRUE(connection.ok()) << connection.status();
    const auto answer =
        (*connection)->Request({"$JS.API." + verb, request.is_null() ? "" : request.dump(), {}}, absl::Seconds(10));
    EXPECT_TRUE(answer.ok()) << verb << ": " << answer.status();
    const json parsed = answer.ok() ? json::parse(answer->content) : json();
    EXPECT_FALSE(parsed.contains("error")) << verb << ": " << parsed.dump();
    return parsed;
  }

  std::unique_ptr<NatsServers> servers_;
  config::v1::QueueConfig config_;
};

TEST_F(JetStreamFailures, ARunKeepsItsJobForAsLongAsItTakes) {
  Serve(1);
  const auto queue = Open();
  const auto other = Open();
  ASSERT_TRUE((*queue)->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  // Three times the lease, as its own clock sees it.
  const absl::Duration until = runtime::SystemClock().Elapsed() + absl::Seconds(3);
  ASSERT_TRUE(other->WaitUntil([&] {
    EXPECT_EQ(other->TakeNow(), nullptr);
    return runtime::SystemClock().Elapsed() > until;
  }));
  EXPECT_FALSE(lease->lost());
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
}

TEST_F(JetStreamFailures, ALostRecordOfAJobKeepsNobodyFromTheOthers) {
  Serve(1);
  const auto queue = Open();
  Make(*queue, "b1", 2);
  for (int i = 0; i < 2; ++i) {
    const auto lease = queue->Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  Ask("STREAM.PURGE.KV_flair-jobs", {{"filter", "$KV.flair-jobs." + BatchJobId("b1", 0)}});
  const auto ends = orchestrator::BatchSource(*queue->operator->(), "b1").next(0);
  ASSERT_TRUE(ends.ok()) << ends.status();
  std::map<std::string, v1::FailureKind> kinds;
  for (const auto& end : *ends) kinds[end.job().id()] = end.job().failure_kind();
  EXPECT_EQ(kinds, (std::map<std::string, v1::FailureKind>{{BatchJobId("b1", 0), v1::FAILURE_KIND_STORE},
                                                           {BatchJobId("b1", 1), v1::FAILURE_KIND_UNSPECIFIED}}));
}

TEST_F(JetStreamFailures, ALostLeaseWritesNothingAnyMore) {
  Serve(1);
  const auto queue = Open();
  ASSERT_TRUE((*queue)->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  // A partition for longer than the lease.
  servers_->Signal(0, SIGSTOP);
  EXPECT_TRUE(queue->WaitUntil([&] { return lease->cancellation().cancelled(); }));
  EXPECT_TRUE(lease->lost());
  EXPECT_FALSE(lease->cancel_requested());
  servers_->Signal(0, SIGCONT);
  const auto other = Open();
  const auto next = other->Take();
  ASSERT_NE(next, nullptr);
  EXPECT_EQ(next->job().attempt_count(), 2);
  EXPECT_TRUE(absl::IsAborted(lease->Record(StageMade(*lease, "brief", 0, 'a'))));
  EXPECT_TRUE(absl::IsAborted(EndAs(*lease, v1::JOB_STATE_SUCCEEDED)));
  EXPECT_TRUE(absl::IsAborted(lease->Return(absl::ZeroDuration(), "late")));
  EXPECT_TRUE(EndAs(*next, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_WORKER).ok());
  EXPECT_THAT(*(*other)->EventsAfter("job-1", 0, 10), SizeIs(1));
}

TEST_F(JetStreamFailures, AServerThatIsKilledAndStartedGoesOnWithAll) {
  Serve(1);
  const auto queue = Open();
  Make(*queue, "b1", 50);
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  servers_->Kill(0);
  ASSERT_TRUE(servers_->Start(0)) << servers_->Log();
  // The run went through it, or another has the job.
  const absl::Status ended = EndAs(*lease, v1::JOB_STATE_SUCCEEDED);
  EXPECT_TRUE(ended.ok() || absl::IsAborted(ended)) << ended;
  std::map<std::string, int> ends;
  if (ended.ok()) ++ends[lease->job().id()];
  while (ends.size() < 50) {
    const auto next = queue->Take();
    ASSERT_NE(next, nullptr) << ends.size();
    const absl::Status status = EndAs(*next, v1::JOB_STATE_SUCCEEDED);
    if (status.ok()) ++ends[next->job().id()];
  }
  for (const auto& [id, count] : ends) EXPECT_EQ(count, 1) << id;
  const auto batch = (*queue)->GetBatch("b1");
  ASSERT_TRUE(batch.ok()) << batch.status();
  EXPECT_EQ(batch->succeeded_count(), 50);
}

TEST_F(JetStreamFailures, WithoutServersCallsSaySoAndLaterGoOn) {
  Serve(1);
  const auto queue = Open();
  ASSERT_TRUE((*queue)->CreateJob(NewJob("job-1"), "r1").ok());
  servers_->Kill(0);
  const auto job = (*queue)->GetJob("job-1");
  EXPECT_TRUE(absl::IsUnavailable(job.status())) << job.status();
  EXPECT_THAT(std::string(job.status().message()), HasSubstr(servers_->address()));
  EXPECT_THAT(std::string(job.status().message()), HasSubstr("If its disk was full, make room and restart it"));
  ASSERT_TRUE(servers_->Start(0));
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
}

TEST_F(JetStreamFailures, AMessageWithoutRecordHoldsNobodyUp) {
  Serve(1);
  const auto queue = Open();
  auto connection = orchestrator::NatsConnection::Open(config_, nullptr);
  ASSERT_TRUE(connection.ok());
  orchestrator::Streams streams(**connection, absl::Seconds(10));
  ASSERT_TRUE(streams.Publish({orchestrator::QueueNames(config_).Single("-"), "never-made", {}}).ok());
  ASSERT_TRUE((*queue)->CreateJob(NewJob("job-1"), "r1").ok());
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->job().id(), "job-1");
}

TEST_F(JetStreamFailures, JobsWhoseMessagesWereNeverSentAreFound) {
  Serve(1);
  {
    const auto queue = Open();
    Make(*queue, "b1", 3);
  }
  // As if the process had died after writing the records and closing the batch.
  Ask("STREAM.PURGE.flair-queue", json::object());
  const auto queue = Open();
  for (int i = 0; i < 3; ++i) {
    const auto lease = queue->Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  }
  EXPECT_TRUE((*queue)->BatchHasEnded("b1").value());
}

TEST_F(JetStreamFailures, EndsThatWereNeverToldAreTold) {
  Serve(1);
  {
    const auto queue = Open();
    Make(*queue, "b1", 2);
    for (int i = 0; i < 2; ++i) {
      const auto lease = queue->Take();
      ASSERT_NE(lease, nullptr);
      ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
    }
  }
  Ask("STREAM.PURGE.flair-ends", json::object());
  const auto queue = Open();
  EXPECT_TRUE(queue->WaitUntil([&] { return (*queue)->BatchHasEnded("b1").value(); }));
  EXPECT_EQ((*queue)->GetBatch("b1")->succeeded_count(), 2);
  EXPECT_THAT(*(*queue)->EndsAfter("b1", 0, 10), SizeIs(2));
  EXPECT_EQ(queue->TakeNow(), nullptr);
}

TEST_F(JetStreamFailures, AJobWithTwoMessagesRunsOnce) {
  Serve(1);
  const auto queue = Open();
  Make(*queue, "b1", 1);
  auto connection = orchestrator::NatsConnection::Open(config_, nullptr);
  ASSERT_TRUE(connection.ok());
  orchestrator::Streams streams(**connection, absl::Seconds(10));
  ASSERT_TRUE(streams.Publish({orchestrator::QueueNames(config_).Batch("-", "b1"), BatchJobId("b1", 0), {}}).ok());
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(queue->TakeNow(), nullptr);
  EXPECT_FALSE(lease->lost());
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
  EXPECT_EQ(queue->TakeNow(), nullptr);
  EXPECT_EQ((*queue)->GetBatch("b1")->succeeded_count(), 1);
}

TEST_F(JetStreamFailures, ConsumersOfEndedBatchesGo) {
  Serve(1);
  const auto queue = Open();
  Make(*queue, "b1", 1);
  {
    const auto lease = queue->Take();
    ASSERT_NE(lease, nullptr);
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_WORKER).ok());
  }
  const auto consumers = [&] { return Ask("CONSUMER.NAMES.flair-queue", json::object()).at("consumers").size(); };
  EXPECT_TRUE(queue->WaitUntil([&] { return consumers() == 0; }));
  ASSERT_TRUE((*queue)->Retry(BatchJobId("b1", 0)).value());
  const auto lease = queue->Take();
  ASSERT_NE(lease, nullptr);
  EXPECT_TRUE(EndAs(*lease, v1::JOB_STATE_SUCCEEDED).ok());
}

TEST_F(JetStreamFailures, NothingIsLeftOfWhatIsDeleted) {
  Serve(1);
  const auto queue = Open();
  const auto artifacts = orchestrator::OpenJetStreamArtifacts(config_, nullptr, runtime::SystemClock());
  ASSERT_TRUE(artifacts.ok()) << artifacts.status();
  const auto run = [&](const std::string& text) {
    const auto lease = queue->Take();
    ASSERT_NE(lease, nullptr);
    v1::Artifact artifact;
    artifact.mutable_brief()->set_text(text);
    const auto ref = (*artifacts)->Put(artifact);
    ASSERT_TRUE(ref.ok()) << ref.status();
    orchestrator::StageRecord record = StageMade(*lease, "brief", 0, 'a', "key-of-" + lease->job().id());
    *record.event.mutable_artifact() = *ref;
    ASSERT_TRUE(lease->Record(record).ok());
    ASSERT_TRUE(EndAs(*lease, v1::JOB_STATE_FAILED, v1::FAILURE_KIND_WORKER).ok());
  };
  Make(*queue, "b1", 3);
  ASSERT_TRUE((*queue)->CreateJob(NewJob("job-1"), "r1").ok());
  // One of several pieces, one of several jobs.
  for (const std::string& text :
       {std::string(1'500'000, 'x'), std::string("own"), std::string("own"), std::string("own")}) {
    run(text);
  }
  ASSERT_TRUE((*queue)->Retry("b1-00000001").value());
  run("again");
  ASSERT_TRUE((*queue)->DeleteJob("job-1", **artifacts).ok());
  ASSERT_TRUE((*queue)->DeleteBatch("b1", 1000, **artifacts)->done);
  const auto all_gone = [&] {
    for (const char* stream : {"flair-queue", "flair-ends", "KV_flair-jobs", "KV_flair-batches", "KV_flair-requests",
                               "KV_flair-index", "KV_flair-artifacts"}) {
      if (Ask(std::string("STREAM.INFO.") + stream, nullptr)["state"]["messages"] != 0) return false;
    }
    return Ask("CONSUMER.NAMES.flair-queue", json::object())["consumers"] == json({"single"});
  };
  EXPECT_TRUE(queue->WaitUntil(all_gone)) << Ask("STREAM.LIST", json::object()).dump(2);
}

TEST_F(JetStreamFailures, AFullServerRefusesAndKeepsWhatItHas) {
  Serve(1, {.config = "", .jetstream = "max_file_store: 1MB"});
  const auto queue = Open();
  ASSERT_TRUE((*queue)->CreateBatch(NewBatch("b1")).ok());
  absl::StatusOr<v1::Batch> added = absl::UnknownError("");
  int64_t jobs = 0;
  for (added = (*queue)->AddJobs("b1", JobsOf("b1", 0, 500), false); added.ok() && jobs < 100'000;
       added = (*queue)->AddJobs("b1", JobsOf("b1", jobs, 500), false)) {
    jobs = added->job_count();
  }
  EXPECT_TRUE(absl::IsResourceExhausted(added.status())) << added.status();
  EXPECT_GT(jobs, 0);
  EXPECT_EQ((*queue)->GetBatch("b1")->job_count(), jobs);
  EXPECT_EQ((*queue)->GetJob(BatchJobId("b1", jobs - 1))->state(), v1::JOB_STATE_QUEUED);
}

TEST_F(JetStreamFailures, QueuesOfDifferentNamesShareServers) {
  Serve(1);
  const auto one = Open();
  config_.set_name("another-2");
  const auto other = Open();
  ASSERT_TRUE((*one)->CreateJob(NewJob("job-1"), "r1").ok());
  EXPECT_EQ(other->TakeNow(), nullptr);
  EXPECT_TRUE(absl::IsNotFound((*other)->GetJob("job-1").status()));
}

TEST_F(JetStreamFailures, OneOfThreeServersMayDie) {
  Serve(3);
  const auto queue = Open();
  Make(*queue, "b1", 30);
  std::map<std::string, int> ends;
  for (int i = 0; ends.size() < 30; ++i) {
    if (i == 5) servers_->Kill(1);
    const auto lease = queue->Take();
    ASSERT_NE(lease, nullptr) << ends.size() << servers_->Log();
    const absl::Status status = EndAs(*lease, v1::JOB_STATE_SUCCEEDED);
    if (status.ok()) ++ends[lease->job().id()];
  }
  for (const auto& [id, count] : ends) EXPECT_EQ(count, 1) << id;
  EXPECT_TRUE(queue->WaitUntil([&] {
    const auto batch = (*queue)->GetBatch("b1");
    return batch.ok() && batch->succeeded_count() == 30;
  }));
}

TEST_F(JetStreamFailures, WrongAddressesAndConfigsAreNamed) {
  const auto open = [&] { return orchestrator::OpenJetStreamQueue(config_, nullptr, runtime::SystemClock()).status(); };
  EXPECT_THAT(std::string(open().message()), HasSubstr("queue.address: missing"));
  config_.set_address("http://127.0.0.1:1");
  EXPECT_THAT(std::string(open().message()), HasSubstr("queue.address: \"http://127.0.0.1:1\" is not a server"));
  config_.set_address("tls://127.0.0.1:1");
  EXPECT_THAT(std::string(open().message()), HasSubstr("runtime.tls.authority_path"));
  config_.set_address("nats://127.0.0.1:1");
  EXPECT_TRUE(absl::IsUnavailable(open()));
  EXPECT_THAT(std::string(open().message()), HasSubstr("no server answers at nats://127.0.0.1:1"));
  config_.set_name("a.b");
  EXPECT_THAT(std::string(open().message()), HasSubstr("queue.name: \"a.b\""));
  config_.set_name("flair");
  config_.set_replica_count(2);
  EXPECT_THAT(std::string(open().message()), HasSubstr("queue.replica_count: 2"));
  config_.set_replica_count(1);
  config_.set_lease_seconds(0);
  EXPECT_THAT(std::string(open().message()), HasSubstr("queue.lease_seconds: 0"));
}

TEST_F(JetStreamFailures, FewerServersThanReplicasAreToldOf) {
  Serve(1);
  config_.set_replica_count(3);
  const auto status = orchestrator::OpenJetStreamQueue(config_, nullptr, runtime::SystemClock()).status();
  EXPECT_TRUE(absl::IsFailedPrecondition(status)) << status;
  EXPECT_THAT(std::string(status.message()), HasSubstr("queue.replica_count"));
}

}  // namespace
}  // namespace flair::testing
