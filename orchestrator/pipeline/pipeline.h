// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/batch/artifact_store.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/executor/bounded_executor.h"

namespace flair::orchestrator {

class StepLog;

struct PipelineOptions {
  // That one call of a stage may take.
  absl::Duration stage_deadline = absl::Seconds(600);
  BackoffPolicy backoff;
  // What this program was built from, for the artifacts that it makes itself.
  std::string build;
  Waiter wait = WaitUnlessCancelled;
};

// Where a run of a job ended. Which stage failed, when one did.
struct PipelineResult {
  absl::Status status;
  std::string stage;
  // What its stages did that is not stored yet, when all is well: for JobEnd.
  std::vector<StageRecord> records = {};
};

// Runs the stages of a job, as many at once as their inputs allow, and stores what each makes before the next begins. A
// stage whose inputs and options have been seen before is not run: its stored artifact is used, unless its file is gone
// or damaged. So a job that was interrupted goes on where it was, by being run again. Several jobs may run at once; the
// arguments outlive it.
class Pipeline {
 public:
  Pipeline(WorkQueue& queue, ArtifactStore& artifacts, StageClients& clients, const runtime::Clock& clock,
           PipelineOptions options)
      : queue_(queue),
        artifacts_(artifacts),
        clients_(clients),
        clock_(clock),
        options_(std::move(options)),
        threads_(std::make_unique<runtime::BoundedExecutor>(kSideStages, kSideStages)) {}

  // Runs the job of the lease, which it neither ends nor returns; its cancellation stops the running calls. When all is
  // well, its artifacts are flushed; otherwise what its stages did is recorded. ABORTED when the lease was lost.
  PipelineResult Run(Lease& lease) const;

 private:
  // Stages of all jobs that run beside another one of their job. Their threads start when first needed.
  static constexpr int kSideStages = 1000;

  PipelineResult RunStages(Lease& lease, StepLog& steps) const;
  void ForAll(size_t count, const std::function<void(size_t)>& task) const;

  WorkQueue& queue_;
  ArtifactStore& artifacts_;
  StageClients& clients_;
  const runtime::Clock& clock_;
  const PipelineOptions options_;
  mutable CatalogCache catalogs_;
  const std::unique_ptr<runtime::BoundedExecutor> threads_;
};

}  // namespace flair::orchestrator
