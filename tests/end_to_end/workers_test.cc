// SPDX-License-Identifier: GPL-3.0-or-later
// A batch whose optimizers are killed, stopped and started anew while it runs: the orchestrator is told nothing and
// never restarted, and what comes out is what comes out of a run that nobody disturbs.
#include <gmock/gmock.h>

#include <csignal>
#include <map>

#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "tests/fixtures/programs.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::testing {
namespace {

using ::testing::SizeIs;

constexpr int kJobs = 6;
// Nobody else listens there, so that a port is free when it is wanted again.
constexpr char kOwnHost[] = "127.0.9.3";

class Optimizers : public ::testing::Test {
 protected:
  // Starts an orchestrator whose optimizers are there, with a store of its own.
  void StartOrchestrator(const std::string& optimizers, const std::string& name) {
    orchestrator_ = std::make_unique<ServerProgram>(
        "flair-orchestrator",
        "store_path: \"" + (folder_ / name).string() + "\" running_job_limit: 4 runtime { log_level: \"error\" }" +
            " stages { language: \"" + language_.address() + "\" translator: \"" + translator_.address() +
            "\" optimizer: \"" + optimizers + "\" renderer: \"" + renderer_.address() + "\" }",
        folder_.path());
    ASSERT_NE(orchestrator_->address(), "");
    stub_ = v1::OrchestratorService::NewStub(*runtime::MakeChannel(orchestrator_->address(), ""));
  }

  // The layouts of a batch, by seed; `after_each` is called when a job has ended, with the number of those that have.
  std::map<int64_t, std::string> RunBatch(const std::function<void(int)>& after_each = [](int) {}) {
    v1::CreateBatchRequest request;
    request.set_request_id("batch");
    for (int seed = 0; seed < kJobs; ++seed) {
      v1::Brief& brief = *request.add_specs()->mutable_brief();
      brief.set_text("A bedroom that is 4m x 5m.");
      brief.set_seed(seed);
    }
    v1::CreateBatchResponse batch;
    grpc::ClientContext create;
    EXPECT_TRUE(stub_->CreateBatch(&create, request, &batch).ok());
    v1::WatchBatchRequest watch;
    watch.set_batch_id(batch.batch().id());
    grpc::ClientContext context;
    auto reader = stub_->WatchBatch(&context, watch);
    std::map<int64_t, std::string> layouts;
    v1::WatchBatchResponse ended;
    while (reader->Read(&ended)) {
      EXPECT_EQ(ended.job().state(), v1::JOB_STATE_SUCCEEDED) << ended.job().error();
      for (const v1::ArtifactRef& ref : ended.job().artifacts()) {
        if (ref.kind() == v1::ARTIFACT_KIND_SOLVED_LAYOUT) layouts[ended.job().spec().brief().seed()] = ref.id();
      }
      after_each(static_cast<int>(layouts.size()));
    }
    return layouts;
  }

  std::map<std::string, v1::WorkerState> States() {
    grpc::ClientContext context;
    v1::GetClusterResponse cluster;
    EXPECT_TRUE(stub_->GetCluster(&context, {}, &cluster).ok());
    std::map<std::string, v1::WorkerState> states;
    for (const v1::WorkerStatus& worker : cluster.orchestrators(0).workers()) states[worker.address()] = worker.state();
    return states;
  }

  std::unique_ptr<ServerProgram> Optimizer(const std::string& listen_address = "127.0.0.1:0") {
    return std::make_unique<ServerProgram>(
        "flair-optimizer",
        "runtime { listen_address: \"" + listen_address + "\" worker_thread_count: 2 log_level: \"error\" }",
        folder_.path());
  }

  TestFolder folder_;
  ServerProgram language_{"flair-language", "runtime { log_level: \"error\" }", folder_.path()};
  ServerProgram translator_{"flair-translator", "runtime { log_level: \"error\" }", folder_.path()};
  ServerProgram renderer_{"flair-renderer", "runtime { log_level: \"error\" }", folder_.path()};
  std::unique_ptr<ServerProgram> orchestrator_;
  std::unique_ptr<v1::OrchestratorService::Stub> stub_;
};

TEST_F(Optimizers, ComeAndGoWhileABatchRuns) {
  const auto steady = Optimizer();
  StartOrchestrator(steady->address(), "undisturbed");
  const std::map<int64_t, std::string> expected = RunBatch();
  ASSERT_THAT(expected, SizeIs(kJobs));

  auto killed = Optimizer(std::string(kOwnHost) + ":0");
  const auto stopped = Optimizer();
  const std::string killed_address = killed->address();
  StartOrchestrator(steady->address() + "," + killed_address + "," + stopped->address(), "disturbed");
  const auto disturb = [&](int ended) {
    if (ended == 1) stopped->process().Signal(SIGSTOP);
    if (ended == 2) {
      killed->process().Signal(SIGKILL);
      killed->process().Wait();
    }
    if (ended == 3) {
      while (States()[killed_address] != v1::WORKER_STATE_GONE) {
      }
      killed = Optimizer(killed_address);
      EXPECT_EQ(killed->address(), killed_address);
    }
  };
  EXPECT_EQ(RunBatch(disturb), expected);
  while (States()[killed_address] != v1::WORKER_STATE_READY) {
  }
  stopped->process().Signal(SIGCONT);
}

}  // namespace
}  // namespace flair::testing
