// SPDX-License-Identifier: GPL-3.0-or-later
// What the orchestrator itself costs a job: stages that answer at once with the artifacts of a real room, so that all
// that is left is the store, the hashes, the events and the calls. Real time depends on the disk, which $TMPDIR
// chooses.
#include <benchmark/benchmark.h>
#include <google/protobuf/text_format.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>

#include "optimizer_worker/constraints/registry.h"
#include "orchestrator/pipeline/backoff_policy.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/service/embedded_for_test.h"
#include "orchestrator/service/fake_workers.h"
#include "orchestrator/store/artifact_files.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/store/temporary_folder.h"
#include "orchestrator/workers/stage_workers.h"
#include "orchestrator/workers/test_worker.h"
#include "tests/fixtures/programs.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::orchestrator {
namespace {

// Answers as the workers of one furnished room.
class RecordedStages final : public StageClients {
 public:
  explicit RecordedStages(const std::string& folder) {
    v1::Artifact artifact;
    artifact.ParseFromString(Read(folder + "/layout.pb"));
    layout_ = artifact.solved_layout();
    graph_ = layout_.graph();
    picture_ = Read(folder + "/plan.png");
    *catalog_.mutable_catalog() = optimizer::MakeCatalog();
  }

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest&, Call&) override {
    v1::DescribeRoomResponse response;
    *response.mutable_room() = graph_.room();
    return response;
  }
  absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest&, Call&) override {
    v1::PlanZonesResponse response;
    *response.mutable_zone_plan() = graph_.zone_plan();
    return response;
  }
  absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest&, Call&) override {
    v1::ListObjectsResponse response;
    *response.mutable_object_list() = graph_.object_list();
    return response;
  }
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest&, Call&) override {
    v1::ChooseStyleResponse response;
    *response.mutable_style_sheet() = graph_.style_sheet();
    return response;
  }
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest&, Call&) override {
    v1::ListConstraintsResponse response;
    *response.mutable_constraint_list() = graph_.constraint_list();
    return response;
  }
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest&, Call&) override {
    v1::CleanConstraintsResponse response;
    *response.mutable_constraint_list() = graph_.constraint_list();
    return response;
  }
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest&, Call&) override {
    v1::TranslateResponse response;
    *response.mutable_layout_graph() = graph_;
    return response;
  }
  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest&,
                                                                      Call&) override {
    return catalog_;
  }
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest&, Call&) override {
    v1::SolveResponse response;
    *response.mutable_solved_layout() = layout_;
    return response;
  }
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest&, Call&) override {
    v1::EvaluateResponse response;
    *response.mutable_edge_outcomes() = layout_.edge_outcomes();
    *response.mutable_metrics() = layout_.metrics();
    return response;
  }
  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest&, Call&) override {
    v1::RenderResponse response;
    v1::Preview& preview = *response.mutable_preview();
    preview.set_view(v1::PREVIEW_VIEW_PLAN);
    preview.set_format(v1::PREVIEW_FORMAT_PNG);
    preview.set_width_px(1600);
    preview.set_height_px(1200);
    preview.set_image(picture_);
    return response;
  }
  absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind, Call&) override { return "1"; }

 private:
  static std::string Read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  v1::SolvedLayout layout_;
  v1::LayoutGraph graph_;
  std::string picture_;
  v1::ListConstraintTypesResponse catalog_;
};

v1::JobSpec SpecOf(int64_t number) {
  v1::JobSpec spec;
  spec.mutable_brief()->set_text("Room " + std::to_string(number));
  return spec;
}

std::string DesignFolder() {
  const char* folder = std::getenv("FLAIR_BENCH_DESIGN");
  return folder == nullptr ? "out" : folder;
}

// The pipeline on its store, without gRPC and without waiting for a turn: the orchestrator's own work.
void BM_JobInThePipeline(benchmark::State& state) {
  TemporaryFolder folder;
  RecordedStages stages(DesignFolder());
  auto queue = *SqliteWorkQueue::Open(folder.path(), runtime::SystemClock());
  ArtifactFiles artifacts(folder.path() + "/artifacts");
  const Pipeline pipeline(*queue, artifacts, stages, runtime::SystemClock(), {});
  int64_t number = 0;
  for (auto _ : state) {
    v1::Job job;
    job.set_id(std::to_string(number));
    *job.mutable_spec() = SpecOf(number++);
    absl::Status status = queue->CreateJob(job, "r" + job.id()).status();
    const std::unique_ptr<Lease> lease = *queue->Take({});
    if (status.ok()) status = pipeline.Run(*lease).status;
    if (status.ok()) status = lease->End({.time = absl::Now()});
    if (!status.ok()) state.SkipWithError(status.ToString().c_str());
  }
}
BENCHMARK(BM_JobInThePipeline)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(300);

// The whole of it in one process: a client that watches, the orchestrator, and the workers' side of every call.
void BM_JobOverGrpc(benchmark::State& state) {
  TemporaryFolder folder;
  RecordedStages stages(DesignFolder());
  FakeWorkers workers(stages);
  config::v1::OrchestratorConfig config;
  config.set_store_path(folder.path());
  config.mutable_runtime()->set_log_level("error");
  EmbeddedForTest orchestrator(config, workers.channels());
  int64_t number = 0;
  for (auto _ : state) {
    const auto job = orchestrator.CreateJob(std::to_string(number), SpecOf(number));
    ++number;
    if (orchestrator.Watch(job->id()).back().state() != v1::JOB_STATE_SUCCEEDED) state.SkipWithError("the job failed");
  }
}
BENCHMARK(BM_JobOverGrpc)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(300);

// CPU time that a process has used.
double CpuSeconds(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  const std::string stat{std::istreambuf_iterator<char>(file), {}};
  std::istringstream fields(stat.substr(stat.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

// flair-orchestrator as a program of its own, its stages on sockets in this process: what one job costs that program.
void BM_JobOfTheProgram(benchmark::State& state) {
  TemporaryFolder folder;
  RecordedStages stages(DesignFolder());
  FakeWorkers workers(stages);
  config::v1::OrchestratorConfig config;
  config.set_store_path(folder.path() + "/store");
  config.set_running_job_limit(4);
  config.mutable_runtime()->set_log_level("error");
  *config.mutable_stages() = workers.addresses();
  std::string text;
  google::protobuf::TextFormat::PrintToString(config, &text);
  flair::testing::ServerProgram program("flair-orchestrator", text, folder.path());
  const auto stub = v1::OrchestratorService::NewStub(*runtime::MakeChannel(program.address(), ""));
  v1::CreateBatchRequest request;
  const int job_count = static_cast<int>(state.range(0));
  double cpu_s = 0;
  for (auto _ : state) {
    request.set_request_id("b" + std::to_string(cpu_s));
    request.clear_specs();
    for (int i = 0; i < job_count; ++i) *request.add_specs() = SpecOf(i + static_cast<int64_t>(1e6 * cpu_s) * 1000);
    const double before = CpuSeconds(program.process().pid());
    runtime::CallContext call;
    using Stub = v1::OrchestratorService::StubInterface;
    auto batch = runtime::UnaryRequest(*stub, &Stub::CreateBatch, request, call);
    if (!batch.ok()) return state.SkipWithError(batch.status().ToString().c_str());
    v1::WatchBatchRequest watch;
    watch.set_batch_id(batch->batch().id());
    grpc::ClientContext context;
    auto reader = stub->WatchBatch(&context, watch);
    v1::WatchBatchResponse ended;
    while (reader->Read(&ended)) {
      if (ended.job().state() != v1::JOB_STATE_SUCCEEDED) state.SkipWithError(ended.job().error().c_str());
    }
    cpu_s += CpuSeconds(program.process().pid()) - before;
  }
  state.counters["cpu_ms_per_job"] = 1000 * cpu_s / static_cast<double>(job_count * state.iterations());
}
BENCHMARK(BM_JobOfTheProgram)->Arg(500)->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(1);

// Calls to so many optimizers that take 10 ms a call and one call at a time, by eight callers each: which part of what
// they could answer together they do.
void BM_CallsToWorkers(benchmark::State& state) {
  const auto ten_milliseconds = [](runtime::CallContext& call) {
    WaitUnlessCancelled(absl::Milliseconds(10), call);
    return absl::OkStatus();
  };
  config::v1::OrchestratorConfig config;
  for (std::string* other : {config.mutable_stages()->mutable_language(), config.mutable_stages()->mutable_translator(),
                             config.mutable_stages()->mutable_renderer()}) {
    *other = "127.0.0.1:1";
  }
  std::vector<std::unique_ptr<TestWorker>> optimizers;
  std::string& addresses = *config.mutable_stages()->mutable_optimizer();
  for (int i = 0; i < state.range(0); ++i) {
    optimizers.push_back(std::make_unique<TestWorker>(ten_milliseconds, TestWorkerOptions{.thread_count = 1}));
    addresses += (addresses.empty() ? "" : ",") + optimizers.back()->address();
  }
  StageWorkers workers(*ConnectStages(config), {}, runtime::SystemClock());
  std::atomic<int> left = 0;
  const auto call_until_done = [&] {
    while (left-- > 0) {
      StageCall call;
      if (!workers.clients().Solve({}, call).ok()) state.SkipWithError("a call failed");
    }
  };
  double answered = 0, possible = 0;
  for (auto _ : state) {
    const int calls = 100 * static_cast<int>(state.range(0));
    left = calls;
    const absl::Time start = absl::Now();
    std::vector<std::thread> callers;
    for (int i = 0; i < 8 * state.range(0); ++i) callers.emplace_back(call_until_done);
    for (std::thread& caller : callers) caller.join();
    answered += calls;
    possible += static_cast<double>(state.range(0)) * absl::FDivDuration(absl::Now() - start, absl::Milliseconds(10));
  }
  state.counters["share_of_possible"] = answered / possible;
}
BENCHMARK(BM_CallsToWorkers)->DenseRange(1, 4)->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace flair::orchestrator
