// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/job.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/executor/executor.h"

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

// What the stages of one run do, with the artifacts that they make, on its way into the store and the queue. A write
// there costs as much as many a stage, so steps that took next to no time are kept back until they are worth one, or
// until the next step that is or the end of the job. A process that is killed takes at most that much work with it,
// which the next run makes again, to the byte. The arguments outlive it. Thread-safe.
class StepLog {
 public:
  enum class Urgency { kMayWait, kAtOnce };

  StepLog(Lease& lease, ArtifactStore& artifacts) : lease_(lease), artifacts_(artifacts) {}

  // Stores the step together with those kept back, or keeps it back too. Errors as ArtifactStore::PutAll and
  // Lease::RecordAll; then none of them is recorded, nor tried again.
  absl::Status Add(StageRecord record, std::optional<SealedArtifact> artifact, Urgency urgency);

  // Stores what was kept back.
  absl::Status Store();

  // Stores the artifacts that were kept back and gives away what is to be recorded, for the job's end.
  absl::StatusOr<std::vector<StageRecord>> TakeLast();

 private:
  // With mutex_ held.
  absl::StatusOr<std::vector<StageRecord>> TakeKept();
  absl::Status StoreKept();

  Lease& lease_;
  ArtifactStore& artifacts_;
  std::mutex mutex_;
  std::vector<StageRecord> kept_;
  std::vector<SealedArtifact> kept_artifacts_;
  // Of the steps kept back, together.
  absl::Duration work_;
};

// Runs single stages of one job for the Pipeline: finds a stored result or makes and stores one. Run may be called from
// several threads at once, for different stages. The arguments outlive it.
class StageRunner {
 public:
  StageRunner(WorkQueue& queue, ArtifactStore& artifacts, StageClients& clients, CatalogCache& catalogs,
              const runtime::Clock& clock, const PipelineOptions& options, Lease& lease, StepLog& steps);

  struct Output {
    v1::Artifact artifact;
    v1::StageTiming timing;
  };
  absl::StatusOr<Output> Run(int stage_index, std::span<const v1::Artifact* const> inputs,
                             std::span<const v1::StageTiming> timings, const v1::ModelUsage& model_usage) const;
  // What is stored, instead of running the stage.
  absl::StatusOr<Output> Reuse(int stage_index, const v1::ArtifactRef& ref) const;

 private:
  using Revision = std::optional<std::string>;

  template <typename Result>
  absl::StatusOr<Result> Retry(const std::function<absl::StatusOr<Result>(const StageRun&)>& function,
                               const StageRun& run) const;
  absl::StatusOr<v1::Artifact> Make(const Stage& stage, const StageRun& run, Revision& revision) const;
  std::string KeyOf(const Stage& stage, const StageRun& run, const Revision& revision) const;
  absl::StatusOr<Output> MakeAndStore(int stage_index, const StageRun& run, Revision revision) const;
  absl::StatusOr<Output> TakeFromEarlierJob(int stage_index) const;
  absl::Status Record(StageRecord record, std::optional<SealedArtifact> artifact, bool paid_for = false) const;
  v1::JobEvent Event(v1::JobEventKind kind, const Stage& stage) const;

  WorkQueue& queue_;
  ArtifactStore& artifacts_;
  StageClients& clients_;
  CatalogCache& catalogs_;
  const runtime::Clock& clock_;
  const PipelineOptions& options_;
  StepLog& steps_;
  const v1::Job& job_;
  runtime::Cancellation& cancellation_;
  // The last event with which each stage ended in an earlier run, so that it is not told twice.
  std::map<std::string, v1::JobEvent, std::less<>> history_;
};

}  // namespace flair::orchestrator
