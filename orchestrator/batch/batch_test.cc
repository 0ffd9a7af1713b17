// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <atomic>
#include <condition_variable>
#include <mutex>

#include "orchestrator/batch/event_hub.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/store/job_store.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

TEST(JobIdSource, SortsByAgeEvenWhenTheClockStandsStill) {
  runtime::FakeClock clock(absl::FromUnixMicros(1779371101000005));
  JobIdSource ids(clock);
  std::string last = ids.Next();
  EXPECT_EQ(last.substr(0, 22), "20260521T134501000005-");
  for (int i = 0; i < 1000; ++i) {
    const std::string next = ids.Next();
    EXPECT_LT(last, next);
    last = next;
  }
}

TEST(EventHub, TellsWatchersOfTheIdUntilTheyUnsubscribe) {
  std::mutex mutex;
  std::condition_variable wake;
  int first = 0;
  int second = 0;
  const auto counts_to = [&](int& count) {
    return [&] {
      std::lock_guard lock(mutex);
      ++count;
      wake.notify_all();
    };
  };
  EventHub hub;
  const int key = hub.Subscribe("j1", counts_to(first));
  hub.Subscribe("j2", counts_to(second));
  const auto wait_for = [&](int in_first, int in_second) {
    std::unique_lock lock(mutex);
    wake.wait(lock, [&] { return first == in_first && second == in_second; });
  };
  hub.Notify("j1");
  wait_for(1, 0);
  hub.Notify("");
  wait_for(2, 1);
  hub.Unsubscribe(key);
  hub.Notify("j1");
  hub.Notify("");
  wait_for(2, 2);
}

TEST(StoreMonitor, NoticesWritesOfOthersAndTheEndOfOwners) {
  TemporaryFolder folder;
  auto store = *JobStore::Open(folder.path());
  auto other = *JobStore::Open(folder.path());
  runtime::TestGate changed;
  runtime::TestGate owner_gone;
  StoreMonitor monitor(*store, {[&] { changed.Open(); }, [&] { owner_gone.Open(); }});
  v1::Job job;
  job.set_id("j1");
  ASSERT_TRUE(other->jobs().Insert(job, "").ok());
  changed.Wait();
  other = nullptr;
  owner_gone.Wait();
}

store::v1::BatchRecord OpenBatch() {
  store::v1::BatchRecord batch;
  batch.mutable_batch()->set_id("b");
  batch.mutable_batch()->set_open(true);
  batch.mutable_batch()->set_state(v1::BATCH_STATE_ACTIVE);
  return batch;
}

v1::Job FirstJob() {
  v1::Job job;
  job.set_id(BatchJobId("b", 0));
  job.set_batch_id("b");
  job.mutable_spec()->mutable_brief()->set_text("A bedroom.");
  return job;
}

// A queue with a batch of one job that waits, after somebody ran `damage` on its database.
std::unique_ptr<WorkQueue> DamagedQueue(const TemporaryFolder& folder, const std::vector<std::string>& damage) {
  const runtime::Clock& clock = runtime::SystemClock();
  {
    const auto queue = *SqliteWorkQueue::Open(folder.path(), clock);
    EXPECT_TRUE(queue->CreateBatch(OpenBatch()).ok());
    const v1::Job job = FirstJob();
    EXPECT_TRUE(queue->AddJobs("b", std::span(&job, 1), true).ok());
  }
  // Each in a connection of its own: what is written to the schema is read when it is opened.
  for (const std::string& sql : damage) {
    EXPECT_EQ((*Database::Open(folder.path() + "/jobs.db", {}))->Execute(sql), absl::OkStatus()) << sql;
  }
  return *SqliteWorkQueue::Open(folder.path(), clock);
}

// As if the index of jobs that wait had not seen what is done in between.
std::vector<std::string> Blinded(const std::string& meanwhile) {
  const auto set = [&](const char* from, const char* to) {
    return fmt::format(
        "PRAGMA writable_schema = ON; UPDATE sqlite_schema SET sql = replace(sql, '{}', '{}') "
        "WHERE name = 'jobs_waiting'",
        from, to);
  };
  return {set("state = 1", "state = 11"), meanwhile, set("state = 11", "state = 1")};
}

TEST(SqliteWorkQueue, TellsThatItHasLostSightOfAJob) {
  TemporaryFolder folder;
  const auto queue = DamagedQueue(folder, Blinded("REINDEX jobs_waiting"));
  std::atomic<int> told = 0;
  queue->Listen({[] {}, [](const std::string&) {}, [&](const std::string&) { ++told; }});
  EXPECT_EQ(*queue->Take({}), nullptr);
  absl::Status status;
  // Within a second or two, in which nothing happens.
  while (status.ok()) status = queue->BatchHasEnded("b").status();
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss);
  EXPECT_THAT(std::string(status.message()), ::testing::AllOf(::testing::HasSubstr(folder.path() + "/jobs.db: "),
                                                              ::testing::HasSubstr("jobs_waiting; restore a good")));
  EXPECT_GT(told, 0) << "so that watchers look";
  queue->Listen({});
}

TEST(SqliteWorkQueue, TakesNoJobThatHasEnded) {
  TemporaryFolder folder;
  const auto queue = DamagedQueue(folder, Blinded("UPDATE jobs SET state = 3"));
  EXPECT_EQ(queue->Take({}).status().code(), absl::StatusCode::kDataLoss);
}

TEST(SqliteWorkQueue, AnEndThatContradictsWhatIsStoredIsDamage) {
  TemporaryFolder folder;
  const auto queue = DamagedQueue(folder, {"INSERT INTO events VALUES ('b-00000000', 2, x'')"});
  const auto lease = *queue->Take({});
  ASSERT_NE(lease, nullptr);
  EXPECT_EQ(lease->End({v1::JOB_STATE_SUCCEEDED, "render", {}}).code(), absl::StatusCode::kDataLoss);
}

TEST(SqliteWorkQueue, AJobThatNobodyHasAnyMoreIsTakenAgain) {
  TemporaryFolder folder;
  const auto queue = DamagedQueue(folder, {});
  auto lease = *queue->Take({});
  ASSERT_NE(lease, nullptr);
  ASSERT_TRUE((*Database::Open(folder.path() + "/jobs.db", {}))->Execute("UPDATE jobs SET attempt_count = 9").ok());
  EXPECT_EQ(lease->End({v1::JOB_STATE_SUCCEEDED, "render", {}}).code(), absl::StatusCode::kAborted);
  lease = nullptr;
  std::unique_ptr<Lease> again;
  // Within a second or two, in which nothing happens.
  while (again == nullptr) {
    EXPECT_FALSE(*queue->BatchHasEnded("b"));
    again = *queue->Take({});
  }
}

TEST(JobRunner, JobsOfABatchWaitForAWorkerWithoutUsingUpRuns) {
  TemporaryFolder folder;
  runtime::FakeClock clock;
  const auto queue = *SqliteWorkQueue::Open(folder.path(), clock);
  ArtifactFiles artifacts(folder.path() + "/artifacts");
  std::atomic<int> outages = 10;
  FakeStages stages([&](std::string_view rpc, StageCall&) {
    const bool away = rpc == "Solve" && outages-- > 0;
    return away ? OfOutage(absl::UnavailableError("no optimizer is there")) : absl::OkStatus();
  });
  PipelineOptions options;
  options.backoff.unavailable_attempt_limit = 1;
  const Pipeline pipeline(*queue, artifacts, stages, clock, options);
  spdlog::logger logger("test");
  ASSERT_TRUE(queue->CreateBatch(OpenBatch()).ok());
  const v1::Job job = FirstJob();
  ASSERT_TRUE(queue->AddJobs("b", std::span(&job, 1), true).ok());
  JobRunner runner(*queue, pipeline, clock, logger, {.attempt_limit = 2});
  while (!HasEnded(*queue->GetJob(job.id()))) {
    clock.Advance(absl::Minutes(1));
    runner.Wake();
  }
  EXPECT_EQ(queue->GetJob(job.id())->state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(stages.calls("Solve"), 11);
}

}  // namespace
}  // namespace flair::orchestrator
