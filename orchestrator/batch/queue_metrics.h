// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/metrics/metrics.h"

namespace flair::orchestrator {

// "succeeded", "failed", "cancelled".
std::string NameOf(v1::JobState state);
// "worker", "timeout" ...; "none" when unspecified.
std::string NameOf(v1::FailureKind kind);

// Where a queue's work is counted; the arguments outlive it. Thread-safe.
class QueueMetrics {
 public:
  explicit QueueMetrics(runtime::Metrics& metrics);

  // Jobs that were asked for and taken in.
  void CountCreated(bool in_batch, int64_t job_count);
  // A run began, so long after the job was made when it is its first.
  void BeginRun(const v1::Job& job, absl::Time now);
  // `outcome`: "ended", "retried" (the job waits for another run), "interrupted" or "lost".
  void EndRun(const std::string& outcome, absl::Duration run_duration);
  // A stage's event was stored.
  void CountStage(const v1::JobEvent& event);
  // A run ended its job.
  void CountEnd(const v1::Job& job, const JobEnd& end);
  void CountDeleted(const Deleted& deleted);
  // What the process last said of itself, and how many jobs wait.
  void SetStatus(const v1::OrchestratorStatus& status);
  void SetQueued(int64_t job_count) { queued_ = static_cast<double>(job_count); }

 private:
  double WorkerCount(const std::string& stage, v1::WorkerState state) const;

  runtime::Metrics& metrics_;
  runtime::Gauge& running_;
  runtime::Histogram& wait_;
  runtime::Histogram& run_duration_;
  runtime::Histogram& job_duration_;
  std::atomic<double> queued_ = 0;
  mutable std::mutex mutex_;
  v1::OrchestratorStatus status_;
  // Last, so that nobody asks for what has gone.
  std::vector<std::unique_ptr<runtime::WatchedValue>> watched_;
};

// Counts and logs what is done on a queue: jobs made, runs, stages, ends. Each log line carries the job's id.
std::unique_ptr<WorkQueue> MakeMeteredWorkQueue(std::unique_ptr<WorkQueue> inner, runtime::Metrics& metrics,
                                                const runtime::Clock& clock, std::shared_ptr<spdlog::logger> logger);

}  // namespace flair::orchestrator
