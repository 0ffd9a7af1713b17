// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <fstream>
#include <future>

#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/testing/embedded_for_test.h"
#include "orchestrator/testing/fake_stages.h"
#include "orchestrator/testing/fake_workers.h"
#include "orchestrator/testing/temporary_folder.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::orchestrator {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Stub = v1::OrchestratorService::StubInterface;

config::v1::OrchestratorConfig Config(const std::string& path) {
  config::v1::OrchestratorConfig config;
  config.set_store_path(path);
  config.set_running_job_limit(2);
  config.mutable_runtime()->set_log_level("error");
  return config;
}

v1::JobSpec Spec(const std::string& text = "A bedroom.") {
  v1::JobSpec spec;
  spec.mutable_brief()->set_text(text);
  return spec;
}

// Holds every Solve until the test lets it go or it is cancelled.
class OrchestratorServiceTest : public ::testing::Test {
 protected:
  void Start() { orchestrator_ = std::make_unique<EmbeddedForTest>(config_, workers_.channels()); }
  absl::Status OnCall(std::string_view rpc, runtime::CallContext& call) {
    if (rpc != "Solve" || !hold_) return absl::OkStatus();
    runtime::OnCancel guard(call.cancellation(), [this] { release_.Open(); });
    solving_.Open();
    release_.Wait();
    return call.CheckAlive();
  }

  TemporaryFolder folder_;
  config::v1::OrchestratorConfig config_ = Config(folder_.path());
  bool hold_ = false;
  runtime::TestGate solving_;
  runtime::TestGate release_;
  FakeStages stages_{[this](std::string_view rpc, runtime::CallContext& call) { return OnCall(rpc, call); }};
  FakeWorkers workers_{stages_};
  std::unique_ptr<EmbeddedForTest> orchestrator_;
};

TEST_F(OrchestratorServiceTest, RunsAJobAndStreamsWhatHappens) {
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  absl::Status status;
  const std::vector<v1::JobEvent> events = orchestrator_->Watch(job.id(), 0, &status);
  EXPECT_TRUE(status.ok()) << status;
  ASSERT_THAT(events, SizeIs(25));
  for (size_t i = 0; i < events.size(); ++i) EXPECT_EQ(events[i].sequence(), static_cast<int64_t>(i + 1));
  EXPECT_EQ(events.back().kind(), v1::JOB_EVENT_KIND_ENDED);
  EXPECT_EQ(events.back().state(), v1::JOB_STATE_SUCCEEDED);
  const v1::Job ended = *orchestrator_->GetJob(job.id());
  EXPECT_EQ(ended.state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_THAT(ended.artifacts(), SizeIs(12));
  EXPECT_TRUE(ended.has_end_time());
}

TEST_F(OrchestratorServiceTest, StreamsFromWhereAWatcherLeftOff) {
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  orchestrator_->Watch(job.id());
  EXPECT_THAT(orchestrator_->Watch(job.id(), 20), SizeIs(5));
}

TEST_F(OrchestratorServiceTest, DoesNotKnowOtherJobs) {
  Start();
  absl::Status status;
  orchestrator_->Watch("nothing", 0, &status);
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(orchestrator_->GetJob("nothing").status().code(), absl::StatusCode::kNotFound);
  EXPECT_EQ(orchestrator_->CancelJob("nothing").code(), absl::StatusCode::kNotFound);
}

TEST_F(OrchestratorServiceTest, ReturnsTheFirstJobForARepeatedRequest) {
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  EXPECT_EQ(orchestrator_->CreateJob("r1", Spec())->id(), job.id());
  EXPECT_EQ(orchestrator_->CreateJob("r1", Spec("A kitchen.")).status().code(), absl::StatusCode::kAlreadyExists);
  EXPECT_NE(orchestrator_->CreateJob("r2", Spec())->id(), job.id());
}

v1::Artifact LayoutOf(EmbeddedForTest& orchestrator, const v1::Job& job) {
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    v1::GetArtifactRequest get;
    get.set_artifact_id(ref.id());
    if (ref.kind() == v1::ARTIFACT_KIND_SOLVED_LAYOUT) return orchestrator.Ask(&Stub::GetArtifact, get)->artifact();
  }
  return {};
}

TEST_F(OrchestratorServiceTest, ALayoutThatIsThereIsDrawnAndNothingElseIsDone) {
  Start();
  const v1::Job designed = *orchestrator_->CreateJob("r1", Spec());
  orchestrator_->Watch(designed.id());
  v1::Artifact layout = LayoutOf(*orchestrator_, *orchestrator_->GetJob(designed.id()));
  layout.mutable_producer()->set_method("placed by hand");
  layout.set_id(ComputeArtifactId(layout));
  const int calls = stages_.all_calls();
  v1::CreateJobRequest request;
  request.set_request_id("r2");
  *request.mutable_spec() = Spec("Ada's bedroom.");
  *request.mutable_layout() = layout;
  const auto made = orchestrator_->Ask(&Stub::CreateJob, request);
  ASSERT_TRUE(made.ok()) << made.status();
  EXPECT_EQ(orchestrator_->Watch(made->job().id()).back().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(stages_.all_calls() - calls, 1);
  EXPECT_EQ(stages_.calls("Render"), 2);
  const v1::Job ended = *orchestrator_->GetJob(made->job().id());
  EXPECT_EQ(ended.stage(), "render");
  ASSERT_THAT(ended.artifacts(), SizeIs(3));
  EXPECT_EQ(ended.artifacts(0).kind(), v1::ARTIFACT_KIND_BRIEF);
  EXPECT_EQ(ended.artifacts(2).kind(), v1::ARTIFACT_KIND_PREVIEW);
  EXPECT_EQ(LayoutOf(*orchestrator_, ended).SerializeAsString(), layout.SerializeAsString());
  EXPECT_EQ(orchestrator_->Ask(&Stub::CreateJob, request)->job().id(), ended.id());
  // Neither another layout nor none is the same request.
  request.mutable_layout()->mutable_producer()->set_method("otherwise");
  request.mutable_layout()->clear_id();
  EXPECT_TRUE(absl::IsAlreadyExists(orchestrator_->Ask(&Stub::CreateJob, request).status()));
  request.clear_layout();
  EXPECT_TRUE(absl::IsAlreadyExists(orchestrator_->Ask(&Stub::CreateJob, request).status()));
}

TEST_F(OrchestratorServiceTest, ALayoutThatIsNoneIsRefused) {
  Start();
  const v1::Job designed = *orchestrator_->CreateJob("r1", Spec());
  orchestrator_->Watch(designed.id());
  v1::CreateJobRequest good;
  good.set_request_id("r2");
  *good.mutable_spec() = Spec();
  *good.mutable_layout() = LayoutOf(*orchestrator_, *orchestrator_->GetJob(designed.id()));
  const auto refused = [&](const std::function<void(v1::CreateJobRequest&)>& spoil) {
    v1::CreateJobRequest request = good;
    spoil(request);
    const absl::Status status = orchestrator_->Ask(&Stub::CreateJob, request).status();
    EXPECT_TRUE(absl::IsInvalidArgument(status)) << status;
    return std::string(status.message());
  };
  EXPECT_THAT(refused([](auto& request) { request.mutable_layout()->mutable_brief()->set_text("A bedroom."); }),
              HasSubstr("layout: holds no solved_layout"));
  EXPECT_THAT(refused([](auto& request) { request.mutable_layout()->mutable_producer()->set_method("other"); }),
              HasSubstr("layout.id"));
  EXPECT_THAT(refused([](auto& request) {
                request.mutable_layout()->mutable_solved_layout()->mutable_placements(0)->set_object_id("nobody");
              }),
              HasSubstr("layout.solved_layout.placements[0]"));
  EXPECT_THAT(refused([](auto& request) {
                request.mutable_layout()->clear_id();
                for (int i = 0; i < 2500; ++i) {
                  v1::Diagnostic& remark = *request.mutable_layout()->mutable_solved_layout()->add_diagnostics();
                  remark.set_severity(v1::SEVERITY_NOTE);
                  remark.set_code("long");
                  remark.set_message(std::string(2000, 'x'));
                }
              }),
              HasSubstr("layout: "));
  EXPECT_THAT(refused([&](auto& request) { request.mutable_spec()->mutable_replay()->set_job_id(designed.id()); }),
              HasSubstr("replay"));
  EXPECT_TRUE(orchestrator_->Ask(&Stub::CreateJob, good).ok());
}

TEST_F(OrchestratorServiceTest, NamesTheFieldOfABadRequest) {
  Start();
  const absl::Status empty = orchestrator_->CreateJob("r1", Spec(" ")).status();
  EXPECT_EQ(empty.code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(empty.message()), HasSubstr("spec.brief.text"));
  EXPECT_THAT(std::string(orchestrator_->CreateJob("", Spec()).status().message()), HasSubstr("request_id"));
}

TEST_F(OrchestratorServiceTest, CancelEndsTheRunningCall) {
  hold_ = true;
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  solving_.Wait();
  EXPECT_TRUE(orchestrator_->CancelJob(job.id()).ok());
  EXPECT_EQ(orchestrator_->Watch(job.id()).back().state(), v1::JOB_STATE_CANCELLED);
  EXPECT_EQ(orchestrator_->GetJob(job.id())->state(), v1::JOB_STATE_CANCELLED);
  EXPECT_TRUE(orchestrator_->CancelJob(job.id()).ok());
  EXPECT_EQ(stages_.calls("Render"), 0);
}

TEST_F(OrchestratorServiceTest, CancelsAWaitingJobAndRefusesJobsBeyondItsLimit) {
  hold_ = true;
  config_.set_running_job_limit(1);
  config_.set_queued_job_limit(1);
  Start();
  const v1::Job running = *orchestrator_->CreateJob("r1", Spec());
  solving_.Wait();
  const v1::Job waiting = *orchestrator_->CreateJob("r2", Spec());
  EXPECT_EQ(orchestrator_->CreateJob("r3", Spec()).status().code(), absl::StatusCode::kResourceExhausted);
  EXPECT_TRUE(orchestrator_->CancelJob(waiting.id()).ok());
  EXPECT_EQ(orchestrator_->Watch(waiting.id()).back().state(), v1::JOB_STATE_CANCELLED);
  EXPECT_TRUE(orchestrator_->CreateJob("r3", Spec()).ok());
  release_.Open();
  EXPECT_EQ(orchestrator_->Watch(running.id()).back().state(), v1::JOB_STATE_SUCCEEDED);
}

TEST_F(OrchestratorServiceTest, AJobInterruptedByAStopGoesOnLater) {
  hold_ = true;
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  solving_.Wait();
  orchestrator_->service().Stop();
  EXPECT_EQ(orchestrator_->GetJob(job.id())->state(), v1::JOB_STATE_QUEUED);
  orchestrator_ = nullptr;
  hold_ = false;
  Start();
  EXPECT_EQ(orchestrator_->Watch(job.id()).back().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(stages_.calls("Translate"), 1);
}

TEST_F(OrchestratorServiceTest, StopEndsStreamsSoThatTheServerCanDrain) {
  hold_ = true;
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  absl::Status status;
  auto watch = std::async(std::launch::async, [&] { return orchestrator_->Watch(job.id(), 0, &status); });
  solving_.Wait();
  orchestrator_->service().Stop();
  watch.get();
  EXPECT_EQ(status.code(), absl::StatusCode::kUnavailable);
}

TEST_F(OrchestratorServiceTest, RunsABatchAndCountsIt) {
  Start();
  v1::CreateBatchRequest request;
  request.set_request_id("b1");
  for (int i = 0; i < 20; ++i) *request.add_specs() = Spec("Room " + std::to_string(i % 7));
  const v1::Batch batch = orchestrator_->Ask(&Stub::CreateBatch, request)->batch();
  EXPECT_EQ(batch.job_count(), 20);
  EXPECT_EQ(orchestrator_->Ask(&Stub::CreateBatch, request)->batch().id(), batch.id());
  v1::ListJobsRequest list;
  list.set_batch_id(batch.id());
  list.set_page_size(15);
  v1::ListJobsResponse page = *orchestrator_->Ask(&Stub::ListJobs, list);
  EXPECT_THAT(page.jobs(), SizeIs(15));
  list.set_page_token(page.next_page_token());
  const v1::ListJobsResponse rest = *orchestrator_->Ask(&Stub::ListJobs, list);
  EXPECT_THAT(rest.jobs(), SizeIs(5));
  EXPECT_THAT(rest.next_page_token(), IsEmpty());
  page.mutable_jobs()->MergeFrom(rest.jobs());
  for (const v1::Job& job : page.jobs()) orchestrator_->Watch(job.id());
  v1::GetBatchRequest get;
  get.set_batch_id(batch.id());
  EXPECT_EQ(orchestrator_->Ask(&Stub::GetBatch, get)->batch().succeeded_count(), 20);
  request.mutable_specs()->RemoveLast();
  EXPECT_EQ(orchestrator_->Ask(&Stub::CreateBatch, request).status().code(), absl::StatusCode::kAlreadyExists);
}

TEST_F(OrchestratorServiceTest, HandsOutArtifactsAndNoticesDamage) {
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  orchestrator_->Watch(job.id());
  v1::GetArtifactRequest request;
  request.set_artifact_id(orchestrator_->GetJob(job.id())->artifacts(1).id());
  EXPECT_EQ(orchestrator_->Ask(&Stub::GetArtifact, request)->artifact().room().room_type(), "bedroom");
  SealedArtifact damaged;
  damaged.ref.set_id(request.artifact_id());
  damaged.bytes = "x";
  ASSERT_TRUE((*LocalArtifacts::Open(folder_.path() + "/artifacts"))->PutAll(std::span(&damaged, 1)).ok());
  EXPECT_EQ(orchestrator_->Ask(&Stub::GetArtifact, request).status().code(), absl::StatusCode::kDataLoss);
}

TEST_F(OrchestratorServiceTest, SaysWhichWorkerIsDown) {
  config::v1::OrchestratorConfig config;
  config.mutable_stages()->set_language("127.0.0.1:1");
  config.mutable_stages()->set_translator("127.0.0.1:1");
  config.mutable_stages()->set_optimizer("127.0.0.1:1");
  config.mutable_stages()->set_renderer("127.0.0.1:1");
  orchestrator_ = std::make_unique<EmbeddedForTest>(config_, *ConnectStages(config));
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  const std::string error = orchestrator_->Watch(job.id()).back().message();
  EXPECT_THAT(error, HasSubstr("language worker at 127.0.0.1:1 is not reachable"));
  EXPECT_THAT(error, HasSubstr("start it or fix stages.language"));
  const v1::Job failed = *orchestrator_->GetJob(job.id());
  EXPECT_EQ(failed.state(), v1::JOB_STATE_FAILED);
  EXPECT_EQ(failed.stage(), "room");
  EXPECT_EQ(failed.error_code(), static_cast<int>(absl::StatusCode::kUnavailable));
}

TEST_F(OrchestratorServiceTest, NamesTheStageWithoutAnAddress) {
  EXPECT_THAT(std::string(ConnectStages({}).status().message()), HasSubstr("stages.language: address \"\""));
}

TEST_F(OrchestratorServiceTest, TwoOrchestratorsShareAStore) {
  Start();
  EmbeddedForTest other(config_, workers_.channels());
  ASSERT_TRUE(other.status().ok());
  std::vector<std::string> ids;
  for (int i = 0; i < 10; ++i) {
    ids.push_back(
        (i % 2 == 0 ? *orchestrator_ : other).CreateJob(std::to_string(i), Spec("Room " + std::to_string(i)))->id());
  }
  for (const std::string& id : ids) {
    EXPECT_THAT(orchestrator_->Watch(id), SizeIs(25));
    EXPECT_THAT(other.Watch(id), SizeIs(25));
  }
  EXPECT_EQ(stages_.calls("Solve"), 10);
}

TEST_F(OrchestratorServiceTest, CancelsAJobThatAnotherOrchestratorRuns) {
  hold_ = true;
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  solving_.Wait();
  EmbeddedForTest other(config_, workers_.channels());
  EXPECT_TRUE(other.CancelJob(job.id()).ok());
  EXPECT_EQ(other.Watch(job.id()).back().state(), v1::JOB_STATE_CANCELLED);
}

TEST_F(OrchestratorServiceTest, LeavesJobsAloneThatWereNotAskedForWhenToldSo) {
  config_.set_requested_jobs_only(true);
  hold_ = true;
  Start();
  const v1::Job job = *orchestrator_->CreateJob("r1", Spec());
  solving_.Wait();
  orchestrator_ = nullptr;
  hold_ = false;
  Start();
  const v1::Job other = *orchestrator_->CreateJob("r2", Spec("A kitchen."));
  EXPECT_EQ(orchestrator_->Watch(other.id()).back().state(), v1::JOB_STATE_SUCCEEDED);
  EXPECT_EQ(orchestrator_->GetJob(job.id())->state(), v1::JOB_STATE_QUEUED);
  EXPECT_EQ(orchestrator_->Watch(job.id()).back().state(), v1::JOB_STATE_SUCCEEDED);
}

}  // namespace
}  // namespace flair::orchestrator
