// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "orchestrator/batch/work_queue.h"
#include "orchestrator/pipeline/pipeline.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

struct JobRunnerOptions {
  // Jobs run at once; none when 0.
  int running_job_limit = 1;
  // Runs only jobs and batches that Request has named, not all that wait.
  bool requested_jobs_only = false;
  // Runs of a job of a batch whose failures may pass. A job that stands alone is run once: somebody waits for it.
  int attempt_limit = 3;
  // Is told, again and again, that the queue is damaged (DATA_LOSS): jobs are no longer taken, or do not end.
  std::function<void(const absl::Status&)> damaged = [](const absl::Status&) {};
};

// What a runner has done since it was made.
struct JobRunnerCounts {
  int running_count = 0;
  int64_t succeeded_count = 0;
  int64_t failed_count = 0;
  int64_t cancelled_count = 0;
  int64_t retried_count = 0;
};

// Takes jobs from the queue and runs them on its own threads until they end. Any number of processes may do the same.
// Thread-safe. The arguments outlive it.
class JobRunner {
 public:
  JobRunner(WorkQueue& queue, const Pipeline& pipeline, const runtime::Clock& clock, spdlog::logger& logger,
            JobRunnerOptions options);
  // As Stop.
  ~JobRunner();

  // There may be a job to run.
  void Wake();

  // These jobs and batches are wanted of this process. Those that another process runs are taken over if it dies.
  void Request(const std::vector<std::string>& job_ids, const std::string& batch_id = "");

  // Interrupts the running jobs, which wait in the queue again, and waits for the threads.
  void Stop();

  JobRunnerCounts counts();

 private:
  void Work();
  absl::StatusOr<std::unique_ptr<Lease>> TakeNext();
  void RunJob(Lease& lease);
  void Settle(Lease& lease, const PipelineResult& result);
  void Fail(Lease& lease, const PipelineResult& result);
  void End(Lease& lease, const JobEnd& end);
  // False when the runner is stopping.
  bool WaitBeforeRepeat();
  // Says what does not work, the same once a minute, however many threads meet it.
  void Complain(const std::string& trouble);
  // The same of what the queue did not do, and will be asked for again.
  void Complain(const std::string& what, const absl::Status& why);
  bool stopping();

  WorkQueue& queue_;
  const Pipeline& pipeline_;
  const runtime::Clock& clock_;
  spdlog::logger& logger_;
  const JobRunnerOptions options_;

  std::mutex mutex_;
  std::condition_variable wake_;
  int64_t generation_ = 0;
  bool stopping_ = false;
  TakeFilter filter_;
  JobRunnerCounts counts_;
  std::map<std::string, absl::Duration> complaints_;
  std::map<std::string, Lease*> running_;
  std::vector<std::thread> threads_;
};

}  // namespace flair::orchestrator
