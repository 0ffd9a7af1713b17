// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/job_runner.h"

#include <fmt/format.h>

#include "orchestrator/pipeline/stage_clients.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// A job whose runs end with their process again and again, and come no further, is what ends it.
constexpr int kLostRunLimit = 20;
constexpr std::chrono::seconds kRepeatDelay(1);

// Runs that ended in a failure that may pass, since the job was made or last retried.
int FailedRuns(const Lease& lease) {
  int failed = 0;
  for (const v1::JobEvent& event : lease.history()) {
    if (event.kind() == v1::JOB_EVENT_KIND_RETRIED) failed = 0;
    if (event.kind() == v1::JOB_EVENT_KIND_WAITING) ++failed;
  }
  return failed;
}

}  // namespace

JobRunner::JobRunner(WorkQueue& queue, const Pipeline& pipeline, const runtime::Clock& clock, spdlog::logger& logger,
                     JobRunnerOptions options)
    : queue_(queue), pipeline_(pipeline), clock_(clock), logger_(logger), options_(options) {
  filter_.any = !options_.requested_jobs_only;
  for (int i = 0; i < options.running_job_limit; ++i) threads_.emplace_back([this] { Work(); });
}

JobRunner::~JobRunner() { Stop(); }

void JobRunner::Wake() {
  std::lock_guard lock(mutex_);
  ++generation_;
  wake_.notify_all();
}

void JobRunner::Request(const std::vector<std::string>& job_ids, const std::string& batch_id) {
  {
    std::lock_guard lock(mutex_);
    filter_.job_ids.insert(job_ids.begin(), job_ids.end());
    if (!batch_id.empty()) filter_.batch_ids.insert(batch_id);
  }
  Wake();
}

void JobRunner::Stop() {
  std::vector<std::thread> threads;
  {
    std::lock_guard lock(mutex_);
    stopping_ = true;
    for (auto& [id, lease] : running_) lease->cancellation().Cancel();
    threads.swap(threads_);
    wake_.notify_all();
  }
  for (std::thread& thread : threads) thread.join();
}

JobRunnerCounts JobRunner::counts() {
  std::lock_guard lock(mutex_);
  return counts_;
}

bool JobRunner::stopping() {
  std::lock_guard lock(mutex_);
  return stopping_;
}

bool JobRunner::WaitBeforeRepeat() {
  std::unique_lock lock(mutex_);
  return !wake_.wait_for(lock, kRepeatDelay, [&] { return stopping_; });
}

void JobRunner::Complain(const std::string& trouble) {
  std::lock_guard lock(mutex_);
  const absl::Duration now = clock_.Elapsed();
  std::erase_if(complaints_, [&](const auto& told) { return now - told.second > absl::Minutes(1); });
  if (complaints_.try_emplace(trouble, now).second) logger_.error("{}", trouble);
}

void JobRunner::Complain(const std::string& what, const absl::Status& why) {
  Complain(fmt::format("{}: {}; will keep trying", what, std::string(why.message())));
  if (absl::IsDataLoss(why)) options_.damaged(why);
}

void JobRunner::Work() {
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const int64_t seen = generation_;
    lock.unlock();
    absl::StatusOr<std::unique_ptr<Lease>> lease = TakeNext();
    if (lease.ok() && *lease != nullptr) RunJob(**lease);
    const bool idle = !lease.ok() || *lease == nullptr;
    if (!lease.ok()) {
      Complain("cannot take a job from the queue", lease.status());
      (void)WaitBeforeRepeat();
    }
    // The lease ends before the thread sleeps.
    if (lease.ok()) lease->reset();
    lock.lock();
    if (idle && lease.ok()) wake_.wait(lock, [&] { return stopping_ || generation_ != seen; });
  }
}

absl::StatusOr<std::unique_ptr<Lease>> JobRunner::TakeNext() {
  TakeFilter filter;
  {
    std::lock_guard lock(mutex_);
    filter = filter_;
  }
  return queue_.Take(filter);
}

void JobRunner::RunJob(Lease& lease) {
  {
    std::lock_guard lock(mutex_);
    running_[lease.job().id()] = &lease;
    ++counts_.running_count;
    if (stopping_) lease.cancellation().Cancel();
  }
  const int lost = lease.lost_run_count();
  if (lost >= kLostRunLimit) {
    const absl::Status error =
        Internal("{} runs of the job in a row died with their process; it is not started again", lost);
    End(lease, {v1::JOB_STATE_FAILED, lease.job().stage(), error, v1::FAILURE_KIND_WORKER, clock_.Now()});
  } else if (!lease.job().has_spec()) {
    const absl::Status error = absl::DataLossError("what the job asks for is damaged in the store");
    End(lease, {v1::JOB_STATE_FAILED, "", error, v1::FAILURE_KIND_STORE, clock_.Now()});
  } else {
    Settle(lease, pipeline_.Run(lease));
  }
  std::lock_guard lock(mutex_);
  running_.erase(lease.job().id());
  --counts_.running_count;
}

void JobRunner::Settle(Lease& lease, const PipelineResult& result) {
  if (result.status.ok()) {
    End(lease, {v1::JOB_STATE_SUCCEEDED, result.stage, {}, v1::FAILURE_KIND_UNSPECIFIED, clock_.Now(), result.records});
  } else if (lease.cancel_requested() && !lease.lost()) {
    End(lease, {v1::JOB_STATE_CANCELLED, result.stage, {}, v1::FAILURE_KIND_UNSPECIFIED, clock_.Now()});
  } else if (!lease.lost() && !stopping() && !IsArtifactGone(result.status)) {
    Fail(lease, result);
  }
  // Otherwise another run has it, or it is given back by the lease's end and makes what is gone again; after a crash,
  // the queue finds out.
}

void JobRunner::Fail(Lease& lease, const PipelineResult& result) {
  const v1::FailureKind kind = KindOfFailure(result.status, result.stage);
  const int failed = FailedRuns(lease);
  const bool again = !lease.job().batch_id().empty() && MayPass(result.status, kind);
  const bool outage = IsOutage(result.status);
  if (!again || (!outage && failed + 1 >= options_.attempt_limit)) {
    return End(lease, {v1::JOB_STATE_FAILED, result.stage, result.status, kind, clock_.Now()});
  }
  if (outage)
    Complain(fmt::format("jobs wait for stage \"{}\": {}", result.stage, std::string(result.status.message())));
  const std::string reason =
      outage ? ""
             : fmt::format("run {} of {} failed at stage \"{}\": {}", failed + 1, options_.attempt_limit, result.stage,
                           std::string(result.status.message()));
  const absl::Duration delay = DelayAfterFailure(failed, lease.job().id());
  absl::Status returned = lease.Return(delay, reason);
  while (!returned.ok() && !lease.lost()) {
    Complain("cannot return a job to the queue", returned);
    if (!WaitBeforeRepeat()) break;
    returned = lease.Return(delay, reason);
  }
  if (!returned.ok()) {
    logger_.error("job {}: cannot be returned to the queue: {}", lease.job().id(), std::string(returned.message()));
    return;
  }
  std::lock_guard lock(mutex_);
  ++counts_.retried_count;
}

// Until it is stored: a full disk or a queue that cannot be reached does not lose the end of a job.
void JobRunner::End(Lease& lease, const JobEnd& end) {
  absl::Status stored = lease.End(end);
  while (!stored.ok() && !lease.lost() && !IsArtifactGone(stored)) {
    Complain("cannot store how a job ended", stored);
    if (!WaitBeforeRepeat()) return;
    stored = lease.End(end);
  }
  if (!stored.ok()) return;
  std::lock_guard lock(mutex_);
  if (end.state == v1::JOB_STATE_SUCCEEDED) ++counts_.succeeded_count;
  if (end.state == v1::JOB_STATE_FAILED) ++counts_.failed_count;
  if (end.state == v1::JOB_STATE_CANCELLED) ++counts_.cancelled_count;
  filter_.job_ids.erase(lease.job().id());
}

}  // namespace flair::orchestrator
