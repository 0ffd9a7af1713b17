// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/job_runner.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>

namespace flair::orchestrator {
namespace {

bool HasEnded(v1::JobState state) {
  return state == v1::JOB_STATE_SUCCEEDED || state == v1::JOB_STATE_FAILED || state == v1::JOB_STATE_CANCELLED;
}

}  // namespace

JobRunner::JobRunner(JobStore& store, const Pipeline& pipeline, const runtime::Clock& clock, spdlog::logger& logger,
                     const PipelineOptions& pipeline_options, JobRunnerOptions options)
    : store_(store),
      pipeline_(pipeline),
      clock_(clock),
      logger_(logger),
      pipeline_options_(pipeline_options),
      options_(options) {
  for (int i = 0; i < std::max(1, options.running_job_limit); ++i) threads_.emplace_back([this] { Work(); });
}

JobRunner::~JobRunner() { Stop(); }

void JobRunner::Wake() {
  std::lock_guard lock(mutex_);
  ++generation_;
  wake_.notify_all();
}

void JobRunner::Request(const std::vector<std::string>& job_ids) {
  {
    std::lock_guard lock(mutex_);
    if (options_.requested_jobs_only) requested_.insert(job_ids.begin(), job_ids.end());
  }
  Wake();
}

void JobRunner::Stop() {
  std::vector<std::thread> threads;
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    for (auto& [id, job] : running_) job->cancellation.Cancel();
    threads.swap(threads_);
    wake_.notify_all();
  }
  for (std::thread& thread : threads) thread.join();
}

void JobRunner::Work() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const int64_t seen = generation_;
    lock.unlock();
    const absl::StatusOr<std::optional<std::string>> claimed = ClaimNext();
    if (!claimed.ok()) logger_.error("cannot take a job from the store: {}", std::string(claimed.status().message()));
    const bool has_job = claimed.ok() && claimed->has_value();
    if (has_job) RunJob(**claimed);
    lock.lock();
    if (!has_job) wake_.wait(lock, [&] { return stopping_ || generation_ != seen; });
  }
}

absl::StatusOr<std::optional<std::string>> JobRunner::ClaimNext() {
  return options_.requested_jobs_only ? ClaimRequested() : store_.jobs().ClaimOldest(store_.owner());
}

// The oldest that waits; those that have ended are forgotten, those that run elsewhere are kept in mind.
absl::StatusOr<std::optional<std::string>> JobRunner::ClaimRequested() {
  std::set<std::string> requested;
  {
    std::lock_guard lock(mutex_);
    requested = requested_;
  }
  const auto forget = [this](const std::string& id) {
    std::lock_guard lock(mutex_);
    requested_.erase(id);
  };
  for (const std::string& id : requested) {
    const absl::StatusOr<bool> claimed = store_.jobs().Claim(id, store_.owner());
    if (!claimed.ok()) return claimed.status();
    const absl::StatusOr<v1::Job> job = store_.jobs().Get(id);
    if (*claimed || !job.ok() || HasEnded(job->state())) forget(id);
    if (*claimed) return id;
  }
  return std::nullopt;
}

void JobRunner::RunJob(const std::string& job_id) {
  const auto running = std::make_shared<RunningJob>();
  {
    std::lock_guard lock(mutex_);
    running_[job_id] = running;
    if (stopping_) running->cancellation.Cancel();
  }
  HonourCancelRequests();
  absl::StatusOr<v1::Job> job = store_.jobs().Get(job_id);
  PipelineResult result{job.status(), ""};
  if (job.ok()) result = pipeline_.Run(*job, running->cancellation);

  absl::StatusOr<bool> cancel_requested = store_.jobs().CancelRequested(job_id);
  bool interrupted;
  {
    std::lock_guard lock(mutex_);
    running_.erase(job_id);
    interrupted = stopping_ && !result.status.ok();
  }
  // Interrupted jobs go back to the queue when the process lets go of its owner lock: Release below or, after a crash,
  // whoever finds the lock free.
  absl::Status stored;
  if (cancel_requested.ok() && *cancel_requested && !result.status.ok() && job.ok()) {
    stored = EndJob(*job, v1::JOB_STATE_CANCELLED, {absl::OkStatus(), result.stage});
  } else if (interrupted) {
    stored = store_.jobs().ReleaseOne(job_id);
  } else if (job.ok()) {
    stored = EndJob(*job, result.status.ok() ? v1::JOB_STATE_SUCCEEDED : v1::JOB_STATE_FAILED, result);
  } else {
    stored = job.status();
  }
  if (!stored.ok()) logger_.error("job {}: cannot store how it ended: {}", job_id, std::string(stored.message()));
}

absl::Status JobRunner::EndJob(v1::Job job, v1::JobState state, const PipelineResult& result) {
  job.set_state(state);
  job.set_stage(result.stage);
  job.set_error(std::string(result.status.message()));
  job.set_error_code(static_cast<int>(result.status.code()));
  *job.mutable_end_time() = google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(clock_.Now()));
  v1::JobEvent event;
  event.set_job_id(job.id());
  event.set_kind(v1::JOB_EVENT_KIND_ENDED);
  event.set_message(job.error());
  event.set_state(state);
  auto transaction = Transaction::Begin(store_.database(), Transaction::Durability::kPowerLoss);
  if (!transaction.ok()) return transaction.status();
  absl::Status status = store_.jobs().End(job);
  if (status.ok()) status = store_.events().Append(event);
  if (status.ok()) status = transaction->Commit();
  if (!status.ok()) return status;
  pipeline_options_.notify(job.id());
  logger_.info("job {} {}{}{}", job.id(), v1::JobState_Name(state), job.error().empty() ? "" : ": ", job.error());
  return absl::OkStatus();
}

absl::Status JobRunner::Cancel(const std::string& job_id) {
  absl::StatusOr<v1::Job> job = absl::UnknownError("");
  {
    auto transaction = Transaction::Begin(store_.database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    job = store_.jobs().Get(job_id);
    if (!job.ok()) return job.status();
    if (HasEnded(job->state())) return absl::OkStatus();
    if (absl::Status status = store_.jobs().RequestCancel(job_id); !status.ok()) return status;
    // A waiting job is taken by us, so that nobody else starts it between here and its end.
    if (job->state() == v1::JOB_STATE_QUEUED) {
      const absl::StatusOr<bool> claimed = store_.jobs().Claim(job_id, store_.owner());
      if (!claimed.ok()) return claimed.status();
    }
    if (absl::Status status = transaction->Commit(); !status.ok()) return status;
  }
  if (job->state() == v1::JOB_STATE_QUEUED) return EndJob(*job, v1::JOB_STATE_CANCELLED, {absl::OkStatus(), ""});
  HonourCancelRequests();
  return absl::OkStatus();
}

void JobRunner::HonourCancelRequests() {
  std::map<std::string, std::shared_ptr<RunningJob>> running;
  {
    std::lock_guard lock(mutex_);
    running = running_;
  }
  for (auto& [id, job] : running) {
    const absl::StatusOr<bool> requested = store_.jobs().CancelRequested(id);
    if (requested.ok() && *requested) job->cancellation.Cancel();
  }
}

}  // namespace flair::orchestrator
