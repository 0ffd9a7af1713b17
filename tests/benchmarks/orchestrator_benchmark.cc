// SPDX-License-Identifier: GPL-3.0-or-later
// What the orchestrator itself costs a job: stages that answer at once with the artifacts of a real room, so that all
// that is left is the store, the hashes, the events and the calls. Real time depends on the disk, which $TMPDIR
// chooses.
#include <benchmark/benchmark.h>

#include <atomic>
#include <thread>

#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/store/local_artifacts.h"
#include "orchestrator/store/sqlite_work_queue.h"
#include "orchestrator/store/temporary_folder.h"
#include "orchestrator/testing/embedded_for_test.h"
#include "orchestrator/testing/fake_workers.h"
#include "orchestrator/testing/test_worker.h"
#include "orchestrator/workers/stage_workers.h"
#include "tests/benchmarks/recorded_stages.h"

namespace flair::orchestrator {
namespace {

absl::Status QueueBatch(WorkQueue& queue, int64_t job_count) {
  store::v1::BatchRecord record;
  record.mutable_batch()->set_id("b");
  record.mutable_batch()->set_state(v1::BATCH_STATE_ACTIVE);
  record.mutable_batch()->set_open(true);
  std::vector<v1::Job> jobs(static_cast<size_t>(job_count));
  for (size_t i = 0; i < jobs.size(); ++i) {
    jobs[i].set_id(BatchJobId("b", static_cast<int64_t>(i)));
    jobs[i].set_batch_id("b");
    jobs[i].set_batch_index(static_cast<int64_t>(i));
    *jobs[i].mutable_spec() = SpecOf(static_cast<int64_t>(i));
  }
  absl::Status status = queue.CreateBatch(record).status();
  if (status.ok()) status = queue.AddJobs("b", jobs, true).status();
  return status;
}

// The pipeline on its store, without gRPC and without waiting for a turn: the orchestrator's own work.
void BM_JobInThePipeline(benchmark::State& state) {
  TemporaryFolder folder;
  RecordedStages stages;
  auto queue = *SqliteWorkQueue::Open(folder.path(), runtime::SystemClock());
  const auto artifacts = *LocalArtifacts::Open(folder.path() + "/artifacts");
  const Pipeline pipeline(*queue, *artifacts, stages, runtime::SystemClock(), {});
  absl::Status status = QueueBatch(*queue, state.max_iterations);
  for (auto _ : state) {
    const std::unique_ptr<Lease> lease = *queue->Take({});
    PipelineResult result = pipeline.Run(*lease);
    status.Update(result.status);
    if (status.ok()) status = lease->End({.time = absl::Now(), .records = std::move(result.records)});
    if (!status.ok()) state.SkipWithError(status.ToString().c_str());
  }
}
BENCHMARK(BM_JobInThePipeline)->MeasureProcessCPUTime()->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(300);

// The whole of it in one process: a client that watches, the orchestrator, and the workers' side of every call.
void BM_JobOverGrpc(benchmark::State& state) {
  TemporaryFolder folder;
  RecordedStages stages;
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
