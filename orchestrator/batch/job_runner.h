// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "flair/v1/job.pb.h"
#include "orchestrator/pipeline/pipeline.h"
#include "orchestrator/store/job_store.h"
#include "spdlog/logger.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/executor/cancellation.h"

namespace flair::orchestrator {

struct JobRunnerOptions {
  // Jobs run at once.
  int running_job_limit = 1;
  // Runs only jobs that Request has named, not all that wait in the store.
  bool requested_jobs_only = false;
};

// Takes QUEUED jobs from the store, oldest first, and runs them on its own threads until they end. Other processes may
// do the same on the same store; each job is run by one of them. Thread-safe. The arguments outlive it.
class JobRunner {
 public:
  JobRunner(JobStore& store, const Pipeline& pipeline, const runtime::Clock& clock, spdlog::logger& logger,
            const PipelineOptions& pipeline_options, JobRunnerOptions options);
  // As Stop.
  ~JobRunner();

  // There may be a job to run.
  void Wake();

  // These jobs are wanted of this process. Those that another process runs are taken over if it dies.
  void Request(const std::vector<std::string>& job_ids);

  // Ends the job, here or, if another process runs it, by asking that one. Ended jobs stay as they are.
  absl::Status Cancel(const std::string& job_id);

  // Cancels those jobs that run here and that another process wants cancelled.
  void HonourCancelRequests();

  // Interrupts the running jobs, which stay QUEUED in the store, and waits for the threads.
  void Stop();

 private:
  struct RunningJob {
    runtime::Cancellation cancellation;
  };
  void Work();
  absl::StatusOr<std::optional<std::string>> ClaimNext();
  absl::StatusOr<std::optional<std::string>> ClaimRequested();
  void RunJob(const std::string& job_id);
  absl::Status EndJob(v1::Job job, v1::JobState state, const PipelineResult& result);

  JobStore& store_;
  const Pipeline& pipeline_;
  const runtime::Clock& clock_;
  spdlog::logger& logger_;
  const PipelineOptions pipeline_options_;
  const JobRunnerOptions options_;

  std::mutex mutex_;
  std::condition_variable wake_;
  int64_t generation_ = 0;
  bool stopping_ = false;
  std::set<std::string> requested_;
  // Shared by the thread that runs the job and one that cancels it.
  std::map<std::string, std::shared_ptr<RunningJob>> running_;
  std::vector<std::thread> threads_;
};

}  // namespace flair::orchestrator
