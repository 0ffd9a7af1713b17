// SPDX-License-Identifier: GPL-3.0-or-later
// What the queue on NATS servers costs the process that uses it, with real servers beside it: jobs queued, and jobs
// taken and ended, a second of time and of this process's CPU. The argument is the number of servers and replicas.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <memory>
#include <thread>
#include <vector>

#include "orchestrator/jetstream/open.h"
#include "tests/contract/queue/watched_queue.h"
#include "tests/fixtures/nats_server.h"
#include "worker_runtime/clock/clock.h"

namespace flair::testing {
namespace {

constexpr int64_t kJobs = 10'000;
constexpr int64_t kJobsAtOnce = 1000;
constexpr int kRunners = 8;

double CpuSeconds() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double ResidentMib() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct Served {
  explicit Served(int64_t count) : servers(static_cast<int>(count)) {
    config::v1::QueueConfig config;
    config.set_address(servers.address());
    config.set_replica_count(static_cast<int>(count));
    auto opened = orchestrator::OpenJetStreamQueue(config, nullptr, runtime::SystemClock());
    if (opened.ok()) queue = std::make_unique<WatchedQueue>(*std::move(opened));
  }
  bool Add(const std::string& batch) {
    if (queue == nullptr || !(*queue)->CreateBatch(NewBatch(batch)).ok()) return false;
    for (int64_t first = 0; first < kJobs; first += kJobsAtOnce) {
      const auto added = (*queue)->AddJobs(batch, JobsOf(batch, first, kJobsAtOnce), first + kJobsAtOnce == kJobs);
      if (!added.ok()) return false;
    }
    return true;
  }
  NatsServers servers;
  std::unique_ptr<WatchedQueue> queue;
};

void SetFigures(benchmark::State& state, double cpu_before) {
  const auto jobs = static_cast<double>(kJobs * state.iterations());
  state.counters["jobs/s"] = benchmark::Counter(jobs, benchmark::Counter::kIsRate);
  state.counters["cpu_us/job"] = 1e6 * (CpuSeconds() - cpu_before) / jobs;
  state.counters["peak_MiB"] = ResidentMib();
}

void QueueJobs(benchmark::State& state) {
  Served served(state.range(0));
  int64_t batch = 0;
  const double cpu_before = CpuSeconds();
  for (auto _ : state) {
    if (!served.Add("b" + std::to_string(batch++))) state.SkipWithError("jobs cannot be added");
  }
  SetFigures(state, cpu_before);
}
BENCHMARK(QueueJobs)->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(2);

// With as many events as a design has.
void TakeAndEndJobs(benchmark::State& state) {
  Served served(state.range(0));
  const auto events = static_cast<int>(state.range(1));
  if (!served.Add("b")) state.SkipWithError("jobs cannot be added");
  const double cpu_before = CpuSeconds();
  for (auto _ : state) {
    std::vector<std::thread> runners;
    for (int runner = 0; runner < kRunners; ++runner) {
      runners.emplace_back([&] {
        while (true) {
          const auto lease = served.queue->TakeNow();
          if (lease == nullptr) {
            if ((*served.queue)->BatchHasEnded("b").value_or(true)) break;
            continue;
          }
          for (int i = 0; i < events; ++i) (void)lease->Record(StageMade(*lease, "brief", i / 2, 'a', "key"));
          (void)EndAs(*lease, v1::JOB_STATE_SUCCEEDED);
        }
      });
    }
    for (std::thread& runner : runners) runner.join();
  }
  SetFigures(state, cpu_before);
  const auto batch = (*served.queue)->GetBatch("b");
  if (!batch.ok() || batch->succeeded_count() != kJobs) state.SkipWithError("not every job ended once");
}
BENCHMARK(TakeAndEndJobs)
    ->ArgNames({"servers", "events"})
    ->Args({1, 0})
    ->Args({1, 24})
    ->Args({3, 0})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

}  // namespace
}  // namespace flair::testing
