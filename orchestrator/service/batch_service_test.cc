// SPDX-License-Identifier: GPL-3.0-or-later
// Batches as clients see them, over gRPC.
#include <gmock/gmock.h>

#include <atomic>
#include <set>

#include "orchestrator/store/database.h"
#include "orchestrator/testing/embedded_for_test.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/fake_workers.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Stub = v1::OrchestratorService::StubInterface;

class BatchServiceTest : public ::testing::Test {
 protected:
  BatchServiceTest() {
    config_.set_store_path(folder_.path());
    config_.set_running_job_limit(2);
    config_.mutable_runtime()->set_log_level("error");
  }
  void Start() { orchestrator_ = std::make_unique<EmbeddedForTest>(config_, workers_.channels()); }

  absl::Status OnCall(std::string_view rpc, runtime::CallContext& call) {
    if (rpc != "DescribeRoom") return absl::OkStatus();
    if (failures_-- > 0) return failure_;
    if (!hold_) return absl::OkStatus();
    runtime::OnCancel guard(call.cancellation(), [this] { release_.Open(); });
    begun_.Open();
    release_.Wait();
    return call.CheckAlive();
  }

  absl::StatusOr<v1::Batch> Open(const std::string& request_id = "r") {
    v1::CreateBatchRequest request;
    request.set_request_id(request_id);
    request.set_open(true);
    request.set_label("briefs.jsonl");
    ASSIGN_OR_RETURN(auto response, orchestrator_->Ask(&Stub::CreateBatch, request));
    return response.batch();
  }

  absl::StatusOr<v1::Batch> Add(const std::string& batch_id, int64_t first, int count, bool last,
                                const std::string& text = "Room ") {
    v1::AddToBatchRequest request;
    request.set_batch_id(batch_id);
    request.set_first_index(first);
    for (int64_t i = first; i < first + count; ++i) {
      request.add_specs()->mutable_brief()->set_text(text + std::to_string(i));
    }
    request.set_last(last);
    ASSIGN_OR_RETURN(auto response, orchestrator_->Ask(&Stub::AddToBatch, request));
    return response.batch();
  }

  // The ends until the stream ends.
  std::vector<v1::WatchBatchResponse> Watch(const std::string& id, int64_t after = 0, absl::Status* status = nullptr) {
    grpc::ClientContext context;
    v1::WatchBatchRequest request;
    request.set_batch_id(id);
    request.set_after_sequence(after);
    auto reader = orchestrator_->stub().WatchBatch(&context, request);
    std::vector<v1::WatchBatchResponse> ends;
    v1::WatchBatchResponse response;
    while (reader->Read(&response)) ends.push_back(response);
    const absl::Status end = runtime::FromGrpcStatus(reader->Finish());
    if (status != nullptr) *status = end;
    return ends;
  }

  template <typename Request>
  static Request About(const std::string& batch_id) {
    Request request;
    request.set_batch_id(batch_id);
    return request;
  }
  v1::Batch Get(const std::string& id) {
    return orchestrator_->Ask(&Stub::GetBatch, About<v1::GetBatchRequest>(id))->batch();
  }

  TemporaryFolder folder_;
  config::v1::OrchestratorConfig config_;
  bool hold_ = false;
  std::atomic<int> failures_ = 0;
  absl::Status failure_ = absl::InvalidArgumentError("brief.text: no room in it");
  runtime::TestGate begun_;
  runtime::TestGate release_;
  FakeStages stages_{[this](std::string_view rpc, runtime::CallContext& call) { return OnCall(rpc, call); }};
  FakeWorkers workers_{stages_};
  std::unique_ptr<EmbeddedForTest> orchestrator_;
};

TEST_F(BatchServiceTest, GrowsPageByPageAndStreamsEveryEndOnce) {
  Start();
  const v1::Batch batch = *Open();
  EXPECT_TRUE(batch.open());
  EXPECT_EQ(batch.label(), "briefs.jsonl");
  ASSERT_TRUE(Add(batch.id(), 0, 3, false).ok());
  ASSERT_TRUE(Add(batch.id(), 3, 4, true).ok());
  absl::Status status = absl::UnknownError("");
  const auto ends = Watch(batch.id(), 0, &status);
  EXPECT_TRUE(status.ok()) << status;
  std::set<int64_t> places;
  int64_t sequence = 0;
  for (const v1::WatchBatchResponse& end : ends) {
    EXPECT_GT(end.sequence(), sequence);
    sequence = end.sequence();
    places.insert(end.job().batch_index());
    EXPECT_EQ(end.job().state(), v1::JOB_STATE_SUCCEEDED) << end.job().error();
    EXPECT_THAT(end.job().artifacts(), SizeIs(12));
  }
  EXPECT_THAT(places, ElementsAre(0, 1, 2, 3, 4, 5, 6));
  EXPECT_THAT(ends, SizeIs(7));
  EXPECT_EQ(Get(batch.id()).succeeded_count(), 7);
  // Who has seen some sees the rest; who has seen all sees the end of the stream.
  EXPECT_THAT(Watch(batch.id(), ends[4].sequence()), SizeIs(2));
  EXPECT_THAT(Watch(batch.id(), sequence, &status), SizeIs(0));
  EXPECT_TRUE(status.ok());
}

TEST_F(BatchServiceTest, AnEmptyBatchEndsWhenItIsClosed) {
  Start();
  const std::string id = Open()->id();
  ASSERT_TRUE(Add(id, 0, 0, true).ok());
  absl::Status status = absl::UnknownError("");
  EXPECT_THAT(Watch(id, 0, &status), SizeIs(0));
  EXPECT_TRUE(status.ok());
}

TEST_F(BatchServiceTest, PagesMayBeGivenAgainButNotChangedNorLeaveGaps) {
  config_.set_takes_no_jobs(true);
  Start();
  const std::string id = Open()->id();
  EXPECT_EQ(Open()->id(), id);
  ASSERT_TRUE(Add(id, 0, 3, false).ok());
  EXPECT_EQ(Add(id, 0, 3, false)->job_count(), 3);
  EXPECT_EQ(Add(id, 2, 3, false)->job_count(), 5);
  EXPECT_EQ(Add(id, 2, 1, false, "Other ").status().code(), absl::StatusCode::kAlreadyExists);
  const absl::Status gap = Add(id, 9, 1, false).status();
  EXPECT_EQ(gap.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(gap.message()), HasSubstr("add from 5 on"));
  ASSERT_TRUE(Add(id, 5, 0, true).ok());
  EXPECT_EQ(Add(id, 4, 1, true)->job_count(), 5);
  EXPECT_EQ(Add(id, 5, 1, false).status().code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_EQ(Add("no-such", 0, 1, false).status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(Add(id, -1, 1, false).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(Get(id).open_count(), 5);
}

TEST_F(BatchServiceTest, ABatchThatIsAskedForTwiceIsOne) {
  Start();
  v1::CreateBatchRequest request;
  request.set_request_id("r");
  request.add_specs()->mutable_brief()->set_text("A bedroom.");
  const v1::Batch first = orchestrator_->Ask(&Stub::CreateBatch, request)->batch();
  EXPECT_FALSE(first.open());
  Watch(first.id());
  EXPECT_EQ(orchestrator_->Ask(&Stub::CreateBatch, request)->batch().id(), first.id());
  request.add_specs()->mutable_brief()->set_text("A kitchen.");
  EXPECT_EQ(orchestrator_->Ask(&Stub::CreateBatch, request).status().code(), absl::StatusCode::kAlreadyExists);
  EXPECT_EQ(Get(first.id()).job_count(), 1);
}

TEST_F(BatchServiceTest, APausedBatchWaitsWhileOthersRun) {
  Start();
  const std::string paused = Open("r1")->id();
  ASSERT_TRUE(orchestrator_->Ask(&Stub::PauseBatch, About<v1::PauseBatchRequest>(paused)).ok());
  ASSERT_TRUE(Add(paused, 0, 3, true).ok());
  const std::string other = Open("r2")->id();
  ASSERT_TRUE(Add(other, 0, 2, true).ok());
  EXPECT_THAT(Watch(other), SizeIs(2));
  EXPECT_EQ(Get(paused).open_count(), 3);
  EXPECT_EQ(Get(paused).state(), v1::BATCH_STATE_PAUSED);
  ASSERT_TRUE(orchestrator_->Ask(&Stub::ResumeBatch, About<v1::ResumeBatchRequest>(paused)).ok());
  EXPECT_THAT(Watch(paused), SizeIs(3));
}

TEST_F(BatchServiceTest, CancelEndsWhatRunsAndWhatWaits) {
  hold_ = true;
  Start();
  const std::string id = Open()->id();
  ASSERT_TRUE(Add(id, 0, 10, false).ok());
  begun_.Wait();
  const v1::Batch cancelled = orchestrator_->Ask(&Stub::CancelBatch, About<v1::CancelBatchRequest>(id))->batch();
  EXPECT_EQ(cancelled.state(), v1::BATCH_STATE_CANCELLED);
  EXPECT_FALSE(cancelled.open());
  EXPECT_THAT(Watch(id), SizeIs(10));
  EXPECT_EQ(Get(id).cancelled_count(), 10);
  const auto resumed = orchestrator_->Ask(&Stub::ResumeBatch, About<v1::ResumeBatchRequest>(id));
  EXPECT_EQ(resumed.status().code(), absl::StatusCode::kFailedPrecondition);
}

TEST_F(BatchServiceTest, FailuresHaveKindsAndCanBeRetried) {
  failures_ = 2;
  Start();
  const std::string id = Open()->id();
  ASSERT_TRUE(Add(id, 0, 5, true).ok());
  const auto ends = Watch(id);
  ASSERT_THAT(ends, SizeIs(5));
  v1::Batch batch = Get(id);
  ASSERT_THAT(batch.failures(), SizeIs(1));
  EXPECT_EQ(batch.failures(0).kind(), v1::FAILURE_KIND_INPUT);
  EXPECT_EQ(batch.failures(0).job_count(), 2);
  v1::RetryBatchRequest others = About<v1::RetryBatchRequest>(id);
  others.add_kinds(v1::FAILURE_KIND_WORKER);
  EXPECT_EQ(orchestrator_->Ask(&Stub::RetryBatch, others)->retried_count(), 0);
  EXPECT_EQ(orchestrator_->Ask(&Stub::RetryBatch, About<v1::RetryBatchRequest>(id))->retried_count(), 2);
  // The two come again, and nobody else.
  EXPECT_THAT(Watch(id, ends.back().sequence()), SizeIs(2));
  batch = Get(id);
  EXPECT_EQ(batch.succeeded_count(), 5);
  EXPECT_EQ(batch.failed_count(), 0);
}

TEST_F(BatchServiceTest, FailuresThatMayPassAreRunAgainInABatchButNotAlone) {
  failure_ = absl::InternalError("a bug that comes and goes");
  failures_ = 1;
  Start();
  v1::JobSpec spec;
  spec.mutable_brief()->set_text("A bedroom.");
  const v1::Job alone = *orchestrator_->CreateJob("alone", spec);
  EXPECT_EQ(orchestrator_->Watch(alone.id()).back().state(), v1::JOB_STATE_FAILED);
  failures_ = 1;
  const std::string id = Open()->id();
  ASSERT_TRUE(Add(id, 0, 1, true).ok());
  const auto ends = Watch(id);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].job().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(ends[0].job().attempt_count(), 2);
  int waited = 0;
  for (const v1::JobEvent& event : orchestrator_->Watch(ends[0].job().id())) {
    waited += event.kind() == v1::JOB_EVENT_KIND_WAITING ? 1 : 0;
  }
  EXPECT_EQ(waited, 1);
}

// Where the damage is met by those who write alone, nobody else would tell the watchers.
TEST_F(BatchServiceTest, WatchersAreToldThatTheStoreIsDamaged) {
  hold_ = true;
  Start();
  const v1::Batch batch = *Open();
  ASSERT_TRUE(Add(batch.id(), 0, 2, true).ok());
  begun_.Wait();
  ASSERT_TRUE((*Database::Open(folder_.path() + "/jobs.db", {}))->Execute("DROP TABLE events").ok());
  release_.Open();
  absl::Status status;
  Watch(batch.id(), 0, &status);
  EXPECT_EQ(status.code(), absl::StatusCode::kDataLoss);
  EXPECT_THAT(std::string(status.message()), HasSubstr("/jobs.db: store: no such table: events"));
}

TEST_F(BatchServiceTest, RunsAreLimited) {
  failure_ = absl::InternalError("always");
  failures_ = 1000;
  config_.set_attempt_limit(2);
  Start();
  const std::string id = Open()->id();
  ASSERT_TRUE(Add(id, 0, 1, true).ok());
  const auto ends = Watch(id);
  ASSERT_THAT(ends, SizeIs(1));
  EXPECT_EQ(ends[0].job().state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(ends[0].job().failure_kind(), v1::FAILURE_KIND_WORKER);
  EXPECT_EQ(ends[0].job().attempt_count(), 2);
}

TEST_F(BatchServiceTest, ListsBatchesAndTellsOfTheCluster) {
  Start();
  for (const char* request : {"r1", "r2", "r3"}) ASSERT_TRUE(Add(Open(request)->id(), 0, 1, true).ok());
  v1::ListBatchesRequest list;
  list.set_page_size(2);
  const auto page = *orchestrator_->Ask(&Stub::ListBatches, list);
  ASSERT_THAT(page.batches(), SizeIs(2));
  list.set_page_token(page.next_page_token());
  const auto rest = *orchestrator_->Ask(&Stub::ListBatches, list);
  ASSERT_THAT(rest.batches(), SizeIs(1));
  EXPECT_LT(rest.batches(0).id(), page.batches(1).id());
  Watch(rest.batches(0).id());
  EXPECT_EQ(orchestrator_->Ask(&Stub::ListBatches, list)->batches(0).succeeded_count(), 1);
  auto cluster = *orchestrator_->Ask(&Stub::GetCluster, v1::GetClusterRequest());
  ASSERT_THAT(cluster.orchestrators(), SizeIs(1));
  EXPECT_EQ(cluster.orchestrators(0).running_limit(), 2);
  // Counted once the end is stored, which watchers hear of first.
  while (cluster.orchestrators(0).succeeded_count() < 1) {
    cluster = *orchestrator_->Ask(&Stub::GetCluster, v1::GetClusterRequest());
  }
}

TEST_F(BatchServiceTest, OtherOrchestratorsGoOnWhereOneStops) {
  hold_ = true;
  Start();
  const std::string id = Open()->id();
  ASSERT_TRUE(Add(id, 0, 4, true).ok());
  begun_.Wait();
  EmbeddedForTest other(config_, workers_.channels());
  hold_ = false;
  orchestrator_ = nullptr;
  grpc::ClientContext context;
  auto reader = other.stub().WatchBatch(&context, About<v1::WatchBatchRequest>(id));
  int succeeded = 0;
  for (v1::WatchBatchResponse end; reader->Read(&end);) succeeded += end.job().state() == v1::JOB_STATE_SUCCEEDED;
  EXPECT_TRUE(reader->Finish().ok());
  EXPECT_EQ(succeeded, 4);
}

}  // namespace
}  // namespace flair::orchestrator
