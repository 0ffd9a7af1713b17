// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/queue_metrics.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/strip.h"
#include "absl/time/time.h"

namespace flair::orchestrator {
namespace {

using runtime::MetricFamily;
using runtime::MetricKind;

// From a second to a day: jobs of a large batch wait long.
constexpr double kJobBuckets[] = {0.1, 0.25, 0.5, 1, 2.5, 5, 10, 30, 60, 180, 600, 1800, 3600, 14400, 86400};

constexpr MetricFamily kCreated{.kind = MetricKind::kCounter,
                                .name = "flair_jobs_created_total",
                                .help = "Jobs accepted, single or of a batch; repeated submissions count again.",
                                .labels = {"form"}};
constexpr MetricFamily kEnded{.kind = MetricKind::kCounter,
                              .name = "flair_jobs_ended_total",
                              .help = "Jobs that ended in a run of this orchestrator.",
                              .labels = {"state", "failure"}};
constexpr MetricFamily kDeletedJobs{
    .kind = MetricKind::kCounter, .name = "flair_jobs_deleted_total", .help = "Jobs that this orchestrator deleted."};
constexpr MetricFamily kDeletedArtifacts{.kind = MetricKind::kCounter,
                                         .name = "flair_artifacts_deleted_total",
                                         .help = "Artifacts that it deleted with their last job."};
constexpr MetricFamily kRuns{
    .kind = MetricKind::kCounter,
    .name = "flair_job_runs_total",
    .help = "Runs of jobs: ended, retried after a temporary failure, interrupted, or lost to another orchestrator.",
    .labels = {"outcome"}};
constexpr MetricFamily kStages{.kind = MetricKind::kCounter,
                               .name = "flair_stages_total",
                               .help = "Stages of jobs: made, reused (from the store) or failed.",
                               .labels = {"stage", "outcome"}};
constexpr MetricFamily kStageDuration{.kind = MetricKind::kHistogram,
                                      .name = "flair_stage_duration_seconds",
                                      .help = "Time to make and store a stage's artifact.",
                                      .labels = {"stage"},
                                      .buckets = runtime::kSecondsBuckets};
constexpr MetricFamily kWait{.kind = MetricKind::kHistogram,
                             .name = "flair_job_wait_seconds",
                             .help = "Time from a job's creation to its first run.",
                             .buckets = kJobBuckets};
constexpr MetricFamily kRunDuration{.kind = MetricKind::kHistogram,
                                    .name = "flair_job_run_duration_seconds",
                                    .help = "Time of one run of a job.",
                                    .buckets = runtime::kSecondsBuckets};
constexpr MetricFamily kJobDuration{.kind = MetricKind::kHistogram,
                                    .name = "flair_job_duration_seconds",
                                    .help = "Time from a job's creation to its end.",
                                    .buckets = kJobBuckets};
constexpr MetricFamily kRunning{
    .kind = MetricKind::kGauge, .name = "flair_jobs_running", .help = "Jobs that this orchestrator is running."};
constexpr MetricFamily kRunningLimit{.kind = MetricKind::kGauge,
                                     .name = "flair_jobs_running_limit",
                                     .help = "Jobs that it may run at once (running_job_limit)."};
constexpr MetricFamily kQueued{.kind = MetricKind::kGauge,
                               .name = "flair_jobs_queued",
                               .help = "Jobs waiting in the queue that its orchestrators share."};
constexpr MetricFamily kWorkers{.kind = MetricKind::kGauge,
                                .name = "flair_workers",
                                .help = "Workers as this orchestrator sees them: ready, broken or gone.",
                                .labels = {"stage", "state"}};

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

}  // namespace

std::string NameOf(v1::JobState state) { return Short(v1::JobState_Name(state), "JOB_STATE_"); }
std::string NameOf(v1::FailureKind kind) { return Short(v1::FailureKind_Name(kind), "FAILURE_KIND_"); }

QueueMetrics::QueueMetrics(runtime::Metrics& metrics)
    : metrics_(metrics),
      running_(metrics.GetGauge(kRunning)),
      wait_(metrics.GetHistogram(kWait)),
      run_duration_(metrics.GetHistogram(kRunDuration)),
      job_duration_(metrics.GetHistogram(kJobDuration)) {
  for (const MetricFamily* family :
       {&kCreated, &kEnded, &kDeletedJobs, &kDeletedArtifacts, &kRuns, &kStages, &kStageDuration})
    metrics.Declare(*family);
  // Of a count that begins with one a rate does not see the first.
  for (const v1::JobState state : {v1::JOB_STATE_SUCCEEDED, v1::JOB_STATE_CANCELLED}) {
    metrics.GetCounter(kEnded, {NameOf(state), NameOf(v1::FAILURE_KIND_UNSPECIFIED)});
  }
  for (int kind = v1::FailureKind_MIN + 1; kind <= v1::FailureKind_MAX; ++kind) {
    metrics.GetCounter(kEnded, {NameOf(v1::JOB_STATE_FAILED), NameOf(static_cast<v1::FailureKind>(kind))});
  }
  watched_.push_back(metrics.Watch(kQueued, {}, [this] { return queued_.load(); }));
  watched_.push_back(metrics.Watch(kRunningLimit, {}, [this] {
    std::lock_guard lock(mutex_);
    return static_cast<double>(status_.running_limit());
  }));
  for (const std::string stage : {"language", "translator", "optimizer", "renderer"}) {
    for (const v1::WorkerState state : {v1::WORKER_STATE_READY, v1::WORKER_STATE_BROKEN, v1::WORKER_STATE_GONE}) {
      const std::string name = Short(v1::WorkerState_Name(state), "WORKER_STATE_");
      watched_.push_back(metrics.Watch(kWorkers, {stage, name}, [=, this] { return WorkerCount(stage, state); }));
    }
  }
}

double QueueMetrics::WorkerCount(const std::string& stage, v1::WorkerState state) const {
  std::lock_guard lock(mutex_);
  return static_cast<double>(std::count_if(
      status_.workers().begin(), status_.workers().end(),
      [&](const v1::WorkerStatus& worker) { return worker.stage() == stage && worker.state() == state; }));
}

void QueueMetrics::CountCreated(bool in_batch, int64_t job_count) {
  metrics_.GetCounter(kCreated, {in_batch ? "batch" : "single"}).Add(static_cast<double>(job_count));
}

void QueueMetrics::BeginRun(const v1::Job& job, absl::Time now) {
  running_.Add(1);
  if (job.attempt_count() <= 1) wait_.Observe(SecondsSince(job.create_time(), now));
}

void QueueMetrics::EndRun(const std::string& outcome, absl::Duration run_duration) {
  running_.Add(-1);
  metrics_.GetCounter(kRuns, {outcome}).Add();
  run_duration_.Observe(absl::ToDoubleSeconds(run_duration));
}

void QueueMetrics::CountStage(const v1::JobEvent& event) {
  if (event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED) {
    metrics_.GetCounter(kStages, {event.stage(), "made"}).Add();
    metrics_.GetHistogram(kStageDuration, {event.stage()}).Observe(Seconds(event.duration()));
  } else if (event.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED) {
    metrics_.GetCounter(kStages, {event.stage(), "reused"}).Add();
  }
}

void QueueMetrics::CountEnd(const v1::Job& job, const JobEnd& end) {
  metrics_.GetCounter(kEnded, {NameOf(end.state), NameOf(end.failure_kind)}).Add();
  if (end.state == v1::JOB_STATE_FAILED && !end.stage.empty())
    metrics_.GetCounter(kStages, {end.stage, "failed"}).Add();
  job_duration_.Observe(SecondsSince(job.create_time(), end.time));
}

void QueueMetrics::CountDeleted(const Deleted& deleted) {
  metrics_.GetCounter(kDeletedJobs).Add(static_cast<double>(deleted.job_count));
  metrics_.GetCounter(kDeletedArtifacts).Add(static_cast<double>(deleted.artifact_count));
}

void QueueMetrics::SetStatus(const v1::OrchestratorStatus& status) {
  std::lock_guard lock(mutex_);
  status_ = status;
}

}  // namespace flair::orchestrator
