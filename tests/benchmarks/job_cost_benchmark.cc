// SPDX-License-Identifier: GPL-3.0-or-later
// What a job of a batch costs flair-orchestrator, the program as a whole, beside stages that answer at once: its store
// in memory (/dev/shm), on the disk ($TMPDIR), and all of it on a real nats-server. Its CPU time is the kernel's count,
// so that of this process, of the servers and of the stages is not in it.
//   FLAIR_BENCH_PROGRAM: another flair-orchestrator than the one that was built, to compare them in one run.
#include <benchmark/benchmark.h>
#include <google/protobuf/text_format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>

#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "optimizer_worker/constraints/registry.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/testing/fake_workers.h"
#include "tests/fixtures/nats_server.h"
#include "tests/fixtures/programs.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::orchestrator {
namespace {

enum class Setting { kMemory, kDisk, kJetStream };

constexpr int kWarmUpJobs = 50;
constexpr int kJobs = 500;

std::string ReadRecorded(const char* name) {
  const char* folder = std::getenv("FLAIR_BENCH_DESIGN");
  const std::string path = std::string(folder == nullptr ? "out" : folder) + "/" + name;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: cannot be read; FLAIR_BENCH_DESIGN is to be a folder that `flair design` wrote\n",
                 path.c_str());
    std::exit(2);
  }
  return {std::istreambuf_iterator<char>(file), {}};
}

// Answers at once, as the workers of the room in $FLAIR_BENCH_DESIGN, else in "out": layout.pb and plan.png, as
// `flair design` writes them.
class RecordedStages final : public StageClients {
 public:
  RecordedStages() {
    v1::Artifact artifact;
    artifact.ParseFromString(ReadRecorded("layout.pb"));
    layout_ = artifact.solved_layout();
    graph_ = layout_.graph();
    preview_.set_view(v1::PREVIEW_VIEW_PLAN);
    preview_.set_format(v1::PREVIEW_FORMAT_PNG);
    preview_.set_width_px(1600);
    preview_.set_height_px(1200);
    preview_.set_image(ReadRecorded("plan.png"));
  }

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest&, Call&) override {
    return With(&v1::DescribeRoomResponse::mutable_room, graph_.room());
  }
  absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest&, Call&) override {
    return With(&v1::PlanZonesResponse::mutable_zone_plan, graph_.zone_plan());
  }
  absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest&, Call&) override {
    return With(&v1::ListObjectsResponse::mutable_object_list, graph_.object_list());
  }
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest&, Call&) override {
    return With(&v1::ChooseStyleResponse::mutable_style_sheet, graph_.style_sheet());
  }
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest&, Call&) override {
    return With(&v1::ListConstraintsResponse::mutable_constraint_list, graph_.constraint_list());
  }
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest&, Call&) override {
    return With(&v1::CleanConstraintsResponse::mutable_constraint_list, graph_.constraint_list());
  }
  absl::StatusOr<v1::CompleteConstraintsResponse> CompleteConstraints(const v1::CompleteConstraintsRequest&,
                                                                      Call&) override {
    return With(&v1::CompleteConstraintsResponse::mutable_constraint_list, graph_.constraint_list());
  }
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest&, Call&) override {
    return With(&v1::TranslateResponse::mutable_layout_graph, graph_);
  }
  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest&,
                                                                      Call&) override {
    return With(&v1::ListConstraintTypesResponse::mutable_catalog, catalog_);
  }
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest&, Call&) override {
    return With(&v1::SolveResponse::mutable_solved_layout, layout_);
  }
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest&, Call&) override {
    v1::EvaluateResponse response = With(&v1::EvaluateResponse::mutable_metrics, layout_.metrics());
    *response.mutable_edge_outcomes() = layout_.edge_outcomes();
    return response;
  }
  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest&, Call&) override {
    return With(&v1::RenderResponse::mutable_preview, preview_);
  }
  absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind, Call&) override { return "1"; }

 private:
  template <typename Response, typename Part>
  static Response With(Part* (Response::*part)(), const Part& value) {
    Response response;
    *(response.*part)() = value;
    return response;
  }

  v1::SolvedLayout layout_;
  v1::LayoutGraph graph_;
  v1::Preview preview_;
  const v1::ConstraintCatalog catalog_ = optimizer::MakeCatalog();
};

// The brief of a room that no other number has.
v1::JobSpec SpecOf(int64_t number) {
  v1::JobSpec spec;
  spec.mutable_brief()->set_text("Room " + std::to_string(number));
  return spec;
}

struct CpuTime {
  double user_s = 0;
  double system_s = 0;
};

// Of a process so far, all its threads.
CpuTime CpuOf(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  const std::string stat{std::istreambuf_iterator<char>(file), {}};
  std::istringstream fields(stat.substr(stat.rfind(')') + 1));
  std::string skipped;
  for (int i = 0; i < 11; ++i) fields >> skipped;
  CpuTime time;
  fields >> time.user_s >> time.system_s;
  const auto ticks = static_cast<double>(sysconf(_SC_CLK_TCK));
  return {time.user_s / ticks, time.system_s / ticks};
}

// A folder in memory or on the disk, gone at the end.
class StoreFolder {
 public:
  explicit StoreFolder(Setting setting) {
    const std::filesystem::path parent =
        setting == Setting::kMemory ? "/dev/shm" : std::filesystem::temp_directory_path();
    path_ = (parent / "flair_bench_XXXXXX").string();
    if (::mkdtemp(path_.data()) == nullptr) std::abort();
  }
  ~StoreFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// The program, its stages, and what it keeps its jobs in.
class Orchestrator {
 public:
  explicit Orchestrator(Setting setting) : folder_(setting), workers_(stages_) {
    config::v1::OrchestratorConfig config;
    if (setting == Setting::kJetStream) {
      servers_ = std::make_unique<flair::testing::NatsServers>();
      config.mutable_queue()->set_address(servers_->address());
    } else {
      config.set_store_path(folder_.path() + "/store");
    }
    config.set_running_job_limit(4);
    config.mutable_runtime()->set_log_level("error");
    *config.mutable_stages() = workers_.addresses();
    std::string text;
    google::protobuf::TextFormat::PrintToString(config, &text);
    const char* other = std::getenv("FLAIR_BENCH_PROGRAM");
    program_ = std::make_unique<flair::testing::ServerProgram>(other == nullptr ? "flair-orchestrator" : other, text,
                                                               folder_.path());
    stub_ = v1::OrchestratorService::NewStub(*runtime::MakeChannel(program_->address(), ""));
  }

  pid_t pid() const { return program_->process().pid(); }

  // Makes a batch of so many jobs and watches it to its end; what went wrong, if anything.
  std::string Run(int job_count) {
    v1::CreateBatchRequest request;
    request.set_request_id("b" + std::to_string(next_job_));
    for (int i = 0; i < job_count; ++i) *request.add_specs() = SpecOf(next_job_++);
    runtime::CallContext call;
    using Stub = v1::OrchestratorService::StubInterface;
    const auto batch = runtime::UnaryRequest(*stub_, &Stub::CreateBatch, request, call);
    if (!batch.ok()) return batch.status().ToString();
    v1::WatchBatchRequest watch;
    watch.set_batch_id(batch->batch().id());
    grpc::ClientContext context;
    const auto reader = stub_->WatchBatch(&context, watch);
    int succeeded = 0;
    v1::WatchBatchResponse ended;
    while (reader->Read(&ended)) {
      if (ended.job().state() != v1::JOB_STATE_SUCCEEDED) return ended.job().error();
      ++succeeded;
    }
    return succeeded == job_count ? "" : "not every job ended";
  }

 private:
  StoreFolder folder_;
  RecordedStages stages_;
  FakeWorkers workers_;
  std::unique_ptr<flair::testing::NatsServers> servers_;
  std::unique_ptr<flair::testing::ServerProgram> program_;
  std::unique_ptr<v1::OrchestratorService::Stub> stub_;
  int64_t next_job_ = 0;
};

void BM_JobOfTheProgram(benchmark::State& state, Setting setting) {
  Orchestrator orchestrator(setting);
  std::string trouble = orchestrator.Run(kWarmUpJobs);
  const CpuTime before = CpuOf(orchestrator.pid());
  for (auto _ : state) {
    if (trouble.empty()) trouble = orchestrator.Run(kJobs);
  }
  if (!trouble.empty()) return state.SkipWithError(trouble.c_str());
  const CpuTime after = CpuOf(orchestrator.pid());
  const double jobs = kJobs * static_cast<double>(state.iterations());
  const double user_ms = 1e3 * (after.user_s - before.user_s) / jobs;
  const double system_ms = 1e3 * (after.system_s - before.system_s) / jobs;
  state.counters["cpu_ms/job"] = user_ms + system_ms;
  state.counters["user_ms/job"] = user_ms;
  state.counters["system_ms/job"] = system_ms;
}
// Each repetition (--benchmark_repetitions=5) has a program of its own.
BENCHMARK_CAPTURE(BM_JobOfTheProgram, memory, Setting::kMemory)->UseRealTime()->Iterations(1);
BENCHMARK_CAPTURE(BM_JobOfTheProgram, disk, Setting::kDisk)->UseRealTime()->Iterations(1);
BENCHMARK_CAPTURE(BM_JobOfTheProgram, jetstream, Setting::kJetStream)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace flair::orchestrator
