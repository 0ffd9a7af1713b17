// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/queue_metrics.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"
#include "absl/time/time.h"
#include "worker_runtime/logging/log.h"

namespace flair::orchestrator {
namespace {

using runtime::MetricFamily;

// From a second to a day: jobs of a large batch wait long.
constexpr double kJobBuckets[] = {0.1, 0.25, 0.5, 1, 2.5, 5, 10, 30, 60, 180, 600, 1800, 3600, 14400, 86400};

constexpr MetricFamily kCreated = runtime::CounterFamily(
    "flair_jobs_created_total", "Jobs accepted, single or of a batch; repeated submissions count again.", {"form"});
constexpr MetricFamily kEnded = runtime::CounterFamily(
    "flair_jobs_ended_total", "Jobs that ended in a run of this orchestrator.", {"state", "failure"});
constexpr MetricFamily kDeletedJobs =
    runtime::CounterFamily("flair_jobs_deleted_total", "Jobs that this orchestrator deleted.");
constexpr MetricFamily kDeletedArtifacts =
    runtime::CounterFamily("flair_artifacts_deleted_total", "Artifacts that it deleted with their last job.");
constexpr MetricFamily kRuns = runtime::CounterFamily(
    "flair_job_runs_total",
    "Runs of jobs: ended, retried after a temporary failure, interrupted, or lost to another orchestrator.",
    {"outcome"});
constexpr MetricFamily kStages = runtime::CounterFamily(
    "flair_stages_total", "Stages of jobs: made, reused (from the store) or failed.", {"stage", "outcome"});
constexpr MetricFamily kStageDuration = runtime::HistogramFamily(
    "flair_stage_duration_seconds", "Time to make and store a stage's artifact.", runtime::kSecondsBuckets, {"stage"});
constexpr MetricFamily kWait =
    runtime::HistogramFamily("flair_job_wait_seconds", "Time from a job's creation to its first run.", kJobBuckets);
constexpr MetricFamily kRunDuration =
    runtime::HistogramFamily("flair_job_run_duration_seconds", "Time of one run of a job.", runtime::kSecondsBuckets);
constexpr MetricFamily kJobDuration =
    runtime::HistogramFamily("flair_job_duration_seconds", "Time from a job's creation to its end.", kJobBuckets);
constexpr MetricFamily kRunning = runtime::GaugeFamily("flair_jobs_running", "Jobs that this orchestrator is running.");
constexpr MetricFamily kRunningLimit =
    runtime::GaugeFamily("flair_jobs_running_limit", "Jobs that it may run at once (running_job_limit).");
constexpr MetricFamily kQueued =
    runtime::GaugeFamily("flair_jobs_queued", "Jobs waiting in the queue that its orchestrators share.");
constexpr MetricFamily kWorkers = runtime::GaugeFamily(
    "flair_workers", "Workers as this orchestrator sees them: ready, broken or gone.", {"stage", "state"});

// "FAILURE_KIND_WORKER" as "worker"; the unspecified one is "none".
std::string Short(const std::string& name, std::string_view prefix) {
  const std::string text =
      absl::AsciiStrToLower(absl::StripPrefix(name, absl::string_view(prefix.data(), prefix.size())));
  return text == "unspecified" ? "none" : text;
}

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

double SecondsSince(const google::protobuf::Timestamp& start, absl::Time now) {
  const absl::Time from = absl::FromUnixSeconds(start.seconds()) + absl::Nanoseconds(start.nanos());
  return std::max(0.0, absl::ToDoubleSeconds(now - from));
}

// "succeeded", "failed", "cancelled".
std::string NameOf(v1::JobState state) { return Short(v1::JobState_Name(state), "JOB_STATE_"); }
// "worker", "timeout" ...; "none" when unspecified.
std::string NameOf(v1::FailureKind kind) { return Short(v1::FailureKind_Name(kind), "FAILURE_KIND_"); }

// Where a queue's work is counted; the arguments outlive it. Thread-safe.
class QueueMetrics {
 public:
  explicit QueueMetrics(runtime::Metrics& metrics)
      : metrics_(metrics),
        running_(metrics.Get(kRunning)),
        wait_(metrics.Get(kWait)),
        run_duration_(metrics.Get(kRunDuration)),
        job_duration_(metrics.Get(kJobDuration)) {
    for (const MetricFamily* family :
         {&kCreated, &kEnded, &kDeletedJobs, &kDeletedArtifacts, &kRuns, &kStages, &kStageDuration})
      metrics.Declare(*family);
    // Of a count that begins with one a rate does not see the first.
    for (const v1::JobState state : {v1::JOB_STATE_SUCCEEDED, v1::JOB_STATE_CANCELLED}) {
      metrics.Get(kEnded, {NameOf(state), NameOf(v1::FAILURE_KIND_UNSPECIFIED)});
    }
    for (int kind = v1::FailureKind_MIN + 1; kind <= v1::FailureKind_MAX; ++kind) {
      metrics.Get(kEnded, {NameOf(v1::JOB_STATE_FAILED), NameOf(static_cast<v1::FailureKind>(kind))});
    }
    watched_.push_back(metrics.Watch(kQueued, {}, [this] { return queued_.load(); }));
    watched_.push_back(metrics.Watch(kRunningLimit, {}, [this] {
      std::lock_guard lock(mutex_);
      return static_cast<double>(status_.running_limit());
    }));
    for (const std::string stage : {"language", "translator", "optimizer", "renderer"}) {
      for (const v1::WorkerState state : {v1::WORKER_STATE_READY, v1::WORKER_STATE_BROKEN, v1::WORKER_STATE_GONE}) {
        const std::string name = Short(v1::WorkerState_Name(state), "WORKER_STATE_");
        watched_.push_back(metrics.Watch(kWorkers, {stage, name}, [=, this] {
          std::lock_guard lock(mutex_);
          return static_cast<double>(std::ranges::count_if(status_.workers(), [&](const v1::WorkerStatus& worker) {
            return worker.stage() == stage && worker.state() == state;
          }));
        }));
      }
    }
  }

  // Jobs that were asked for and taken in.
  void CountCreated(bool in_batch, int64_t job_count) {
    metrics_.Get(kCreated, {in_batch ? "batch" : "single"}).Add(static_cast<double>(job_count));
  }

  // A run began, so long after the job was made when it is its first.
  void BeginRun(const v1::Job& job, absl::Time now) {
    running_.Add(1);
    if (job.attempt_count() <= 1) wait_.Add(SecondsSince(job.create_time(), now));
  }

  // `outcome`: "ended", "retried" (the job waits for another run), "interrupted" or "lost".
  void EndRun(const std::string& outcome, absl::Duration run_duration) {
    running_.Add(-1);
    metrics_.Get(kRuns, {outcome}).Add();
    run_duration_.Add(absl::ToDoubleSeconds(run_duration));
  }

  // A stage's event was stored.
  void CountStage(const v1::JobEvent& event) {
    const bool made = event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED;
    if (!made && event.kind() != v1::JOB_EVENT_KIND_STAGE_REUSED) return;
    metrics_.Get(kStages, {event.stage(), made ? "made" : "reused"}).Add();
    if (made) metrics_.Get(kStageDuration, {event.stage()}).Add(Seconds(event.duration()));
  }

  // A run ended its job.
  void CountEnd(const v1::Job& job, const JobEnd& end) {
    metrics_.Get(kEnded, {NameOf(end.state), NameOf(end.failure_kind)}).Add();
    if (end.state == v1::JOB_STATE_FAILED && !end.stage.empty()) metrics_.Get(kStages, {end.stage, "failed"}).Add();
    job_duration_.Add(SecondsSince(job.create_time(), end.time));
  }

  void CountDeleted(const Deleted& deleted) {
    metrics_.Get(kDeletedJobs).Add(static_cast<double>(deleted.job_count));
    metrics_.Get(kDeletedArtifacts).Add(static_cast<double>(deleted.artifact_count));
  }

  // What the process last said of itself.
  void SetStatus(const v1::OrchestratorStatus& status) {
    std::lock_guard lock(mutex_);
    status_ = status;
  }

  // How many jobs wait.
  void SetQueued(int64_t job_count) { queued_ = static_cast<double>(job_count); }

 private:
  runtime::Metrics& metrics_;
  runtime::Meter& running_;
  runtime::Meter& wait_;
  runtime::Meter& run_duration_;
  runtime::Meter& job_duration_;
  std::atomic<double> queued_ = 0;
  std::mutex mutex_;
  v1::OrchestratorStatus status_;
  // Last, so that nobody asks for what has gone.
  std::vector<std::unique_ptr<runtime::WatchedValue>> watched_;
};

using runtime::Log;

struct Meters {
  QueueMetrics& metrics;
  const runtime::Clock& clock;
  spdlog::logger& logger;
};

// A run, from Take until it is destroyed.
class MeteredLease final : public Lease {
 public:
  MeteredLease(std::unique_ptr<Lease> inner, const Meters& meters)
      : Lease(inner->taken()), inner_(std::move(inner)), meters_(meters), start_(meters.clock.Elapsed()) {
    meters_.metrics.BeginRun(job(), meters_.clock.Now());
    Log(meters_.logger, spdlog::level::info, "job taken",
        {{"job_id", job().id()}, {"batch_id", job().batch_id()}, {"attempt", int64_t{job().attempt_count()}}});
  }
  ~MeteredLease() override {
    const bool lost = outcome_ == "interrupted" && inner_->lost();
    meters_.metrics.EndRun(lost ? "lost" : outcome_, Taken());
    if (outcome_ == "interrupted") {
      Log(meters_.logger, spdlog::level::info, lost ? "job lost to another run" : "job interrupted",
          {{"job_id", job().id()}, {"batch_id", job().batch_id()}});
    }
  }

  runtime::Cancellation& cancellation() override { return inner_->cancellation(); }
  bool cancel_requested() override { return inner_->cancel_requested(); }
  bool lost() override { return inner_->lost(); }

  absl::Status Announce(std::span<const StageRecord> records) override { return inner_->Announce(records); }
  absl::Status RecordAll(std::span<const StageRecord> records) override {
    absl::Status status = inner_->RecordAll(records);
    if (status.ok()) CountStages(records);
    return status;
  }

  absl::Status End(const JobEnd& end) override {
    absl::Status status = inner_->End(end);
    if (!status.ok()) return status;
    outcome_ = "ended";
    CountStages(end.records);
    meters_.metrics.CountEnd(job(), end);
    const std::string state = NameOf(end.state);
    const std::string failure = end.error.ok() ? "" : NameOf(end.failure_kind);
    const std::string error = std::string(end.error.message()).substr(0, kLongestError);
    Log(meters_.logger, end.error.ok() ? spdlog::level::info : spdlog::level::warn, "job ended",
        {{"job_id", job().id()},
         {"batch_id", job().batch_id()},
         {"state", state},
         {"stage", end.error.ok() ? "" : std::string_view(end.stage)},
         {"failure", failure},
         {"duration_ms", absl::ToDoubleMilliseconds(Taken())},
         {"error", error}});
    return status;
  }

  absl::Status Return(absl::Duration delay, const std::string& reason) override {
    absl::Status status = inner_->Return(delay, reason);
    if (!status.ok()) return status;
    if (!reason.empty()) outcome_ = "retried";
    Log(meters_.logger, reason.empty() ? spdlog::level::info : spdlog::level::warn, "job waits for another run",
        {{"job_id", job().id()},
         {"batch_id", job().batch_id()},
         {"delay_ms", absl::ToDoubleMilliseconds(delay)},
         {"reason", std::string_view(reason).substr(0, kLongestError)}});
    return status;
  }

 private:
  static constexpr size_t kLongestError = 500;
  absl::Duration Taken() const { return meters_.clock.Elapsed() - start_; }

  void CountStages(std::span<const StageRecord> records) {
    for (const StageRecord& record : records) {
      const v1::JobEvent& event = record.event;
      meters_.metrics.CountStage(event);
      const bool made = event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED;
      if (!made && event.kind() != v1::JOB_EVENT_KIND_STAGE_REUSED) continue;
      Log(meters_.logger, spdlog::level::info, made ? "stage made" : "stage reused",
          {{"job_id", job().id()},
           {"batch_id", job().batch_id()},
           {"stage", event.stage()},
           {"artifact_id", event.artifact().id()},
           {"duration_ms", 1e3 * static_cast<double>(event.duration().seconds()) + 1e-6 * event.duration().nanos()}});
    }
  }

  const std::unique_ptr<Lease> inner_;
  const Meters meters_;
  const absl::Duration start_;
  std::string outcome_ = "interrupted";
};

class MeteredWorkQueue final : public WorkQueue {
 public:
  MeteredWorkQueue(std::unique_ptr<WorkQueue> inner, runtime::Metrics& metrics, const runtime::Clock& clock,
                   std::shared_ptr<spdlog::logger> logger)
      : metrics_(metrics), clock_(clock), logger_(std::move(logger)), inner_(std::move(inner)) {}

  absl::StatusOr<v1::Job> CreateJob(const v1::Job& job, const std::string& request_id,
                                    const GivenArtifact* given) override {
    absl::StatusOr<v1::Job> made = inner_->CreateJob(job, request_id, given);
    if (!made.ok() || made->id() != job.id()) return made;
    metrics_.CountCreated(false, 1);
    Log(*logger_, spdlog::level::info, "job made", {{"job_id", job.id()}, {"request_id", request_id}});
    return made;
  }
  absl::StatusOr<v1::Batch> AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs, bool last) override {
    absl::StatusOr<v1::Batch> batch = inner_->AddJobs(batch_id, jobs, last);
    if (batch.ok()) metrics_.CountCreated(true, static_cast<int64_t>(jobs.size()));
    return batch;
  }
  absl::StatusOr<std::unique_ptr<Lease>> Take(const TakeFilter& filter) override {
    absl::StatusOr<std::unique_ptr<Lease>> lease = inner_->Take(filter);
    if (!lease.ok() || *lease == nullptr) return lease;
    return std::make_unique<MeteredLease>(*std::move(lease), Meters{metrics_, clock_, *logger_});
  }
  absl::Status ReportStatus(const v1::OrchestratorStatus& status) override {
    metrics_.SetStatus(status);
    // Asked for here, on the thread that reports: who looks at figures is not to wait for the queue.
    if (const absl::StatusOr<int64_t> queued = inner_->CountQueued(); queued.ok()) metrics_.SetQueued(*queued);
    return inner_->ReportStatus(status);
  }

  void Listen(Listener listener) override { inner_->Listen(std::move(listener)); }
  absl::StatusOr<store::v1::BatchRecord> CreateBatch(const store::v1::BatchRecord& batch) override {
    return inner_->CreateBatch(batch);
  }
  absl::StatusOr<bool> HasRequest(RequestKind kind, const std::string& owner, const std::string& request_id) override {
    return inner_->HasRequest(kind, owner, request_id);
  }
  absl::Status Cancel(const std::string& job_id, absl::Time now) override { return inner_->Cancel(job_id, now); }
  absl::StatusOr<bool> Retry(const std::string& job_id) override { return inner_->Retry(job_id); }
  absl::Status SetBatchState(const std::string& batch_id, v1::BatchState state) override {
    return inner_->SetBatchState(batch_id, state);
  }
  absl::Status CancelBatch(const std::string& batch_id, absl::Time now) override {
    return inner_->CancelBatch(batch_id, now);
  }
  absl::StatusOr<Deleted> DeleteJob(const std::string& job_id, ArtifactStore& artifacts) override {
    return CountDeleted(inner_->DeleteJob(job_id, artifacts), "job_id", job_id);
  }
  absl::StatusOr<Deleted> DeleteBatch(const std::string& batch_id, int job_limit, ArtifactStore& artifacts) override {
    return CountDeleted(inner_->DeleteBatch(batch_id, job_limit, artifacts), "batch_id", batch_id);
  }
  absl::StatusOr<Deleted> FinishDeletions(ArtifactStore& artifacts) override {
    return CountDeleted(inner_->FinishDeletions(artifacts), "job_id", "");
  }
  absl::StatusOr<EndedPage> EndedBefore(absl::Time time, const std::string& after, int limit) override {
    return inner_->EndedBefore(time, after, limit);
  }
  absl::StatusOr<std::optional<v1::ArtifactRef>> FindResult(const std::string& key) override {
    return inner_->FindResult(key);
  }
  absl::StatusOr<v1::Job> GetJob(const std::string& job_id) override { return inner_->GetJob(job_id); }
  absl::StatusOr<std::vector<v1::Job>> ListJobs(const ListFilter& filter) override { return inner_->ListJobs(filter); }
  absl::StatusOr<std::vector<v1::JobEvent>> EventsAfter(const std::string& job_id, int64_t sequence,
                                                        int limit) override {
    return inner_->EventsAfter(job_id, sequence, limit);
  }
  absl::StatusOr<v1::Batch> GetBatch(const std::string& batch_id) override { return inner_->GetBatch(batch_id); }
  absl::StatusOr<v1::Batch> FindBatch(const std::string& batch_id) override { return inner_->FindBatch(batch_id); }
  absl::StatusOr<std::vector<v1::Batch>> ListBatches(const ListFilter& filter) override {
    return inner_->ListBatches(filter);
  }
  absl::StatusOr<bool> BatchHasEnded(const std::string& batch_id) override { return inner_->BatchHasEnded(batch_id); }
  absl::StatusOr<std::vector<BatchEnd>> EndsAfter(const std::string& batch_id, int64_t sequence, int limit) override {
    return inner_->EndsAfter(batch_id, sequence, limit);
  }
  absl::StatusOr<int64_t> CountQueued() override { return inner_->CountQueued(); }
  absl::StatusOr<int64_t> CountOpen(const std::string& owner) override { return inner_->CountOpen(owner); }
  absl::StatusOr<bool> OwnsArtifact(const std::string& owner, const std::string& artifact_id) override {
    return inner_->OwnsArtifact(owner, artifact_id);
  }
  absl::StatusOr<std::vector<v1::OrchestratorStatus>> Orchestrators() override { return inner_->Orchestrators(); }

 private:
  // Counts and says what was deleted of `what`.
  absl::StatusOr<Deleted> CountDeleted(absl::StatusOr<Deleted> deleted, std::string_view what, const std::string& id) {
    if (!deleted.ok() || (deleted->job_count == 0 && deleted->artifact_count == 0)) return deleted;
    metrics_.CountDeleted(*deleted);
    Log(*logger_, spdlog::level::info, "deleted",
        {{what, id}, {"job_count", deleted->job_count}, {"artifact_count", deleted->artifact_count}});
    return deleted;
  }

  QueueMetrics metrics_;
  const runtime::Clock& clock_;
  const std::shared_ptr<spdlog::logger> logger_;
  const std::unique_ptr<WorkQueue> inner_;
};

}  // namespace

std::unique_ptr<WorkQueue> MakeMeteredWorkQueue(std::unique_ptr<WorkQueue> inner, runtime::Metrics& metrics,
                                                const runtime::Clock& clock, std::shared_ptr<spdlog::logger> logger) {
  return std::make_unique<MeteredWorkQueue>(std::move(inner), metrics, clock, std::move(logger));
}

}  // namespace flair::orchestrator
