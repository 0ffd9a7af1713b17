// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/job_admission.h"

#include <fmt/format.h>

#include <algorithm>

#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

std::shared_ptr<std::mutex> JobAdmission::TurnOf(const std::string& owner) {
  std::lock_guard lock(mutex_);
  std::erase_if(turns_, [](const auto& turn) { return turn.second.expired(); });
  std::weak_ptr<std::mutex>& known = turns_[owner];
  std::shared_ptr<std::mutex> turn = known.lock();
  if (turn == nullptr) known = turn = std::make_shared<std::mutex>();
  return turn;
}

JobAdmission::Entry::Entry(JobAdmission& admission, const Caller& caller) : admission_(admission), caller_(caller) {
  if (caller.open_job_limit == 0) return;
  turn_ = admission.TurnOf(caller.name);
  turn_->lock();
}

JobAdmission::Entry::~Entry() {
  {
    std::lock_guard lock(admission_.mutex_);
    admission_.kept_ -= kept_;
  }
  if (turn_ != nullptr) turn_->unlock();
}

absl::StatusOr<JobAdmission::Entry::Counts> JobAdmission::Entry::Keep(int64_t job_count) {
  int64_t others = 0;
  {
    // Before the queue is counted: what others add meanwhile is counted twice rather than not at all.
    std::lock_guard lock(admission_.mutex_);
    others = admission_.kept_ - kept_;
    admission_.kept_ = others + job_count;
    kept_ = job_count;
  }
  ASSIGN_OR_RETURN(const int64_t queued, admission_.queue_.CountQueued());
  Counts counts = {.queued = queued + others};
  if (turn_ == nullptr) return counts;
  ASSIGN_OR_RETURN(counts.open, admission_.queue_.CountOpen(caller_.name));
  return counts;
}

absl::Status JobAdmission::Entry::Check(const Counts& counts, int64_t job_count) const {
  if (counts.queued + job_count <= admission_.queued_job_limit_) return caller_.CheckOpenJobs(counts.open, job_count);
  return absl::ResourceExhaustedError(
      fmt::format("{} jobs are waiting; {} more would exceed the limit of {}; try again later", counts.queued,
                  job_count, admission_.queued_job_limit_));
}

absl::Status JobAdmission::Entry::Grant(int64_t job_count) {
  if (job_count <= kept_) return absl::OkStatus();
  const absl::StatusOr<Counts> counts = Keep(job_count);
  const absl::Status status = counts.ok() ? Check(*counts, job_count) : counts.status();
  if (status.ok()) return status;
  std::lock_guard lock(admission_.mutex_);
  admission_.kept_ -= kept_;
  kept_ = 0;
  return status;
}

absl::StatusOr<int64_t> JobAdmission::Entry::GrantSome(int64_t job_count) {
  ASSIGN_OR_RETURN(const Counts counts, Keep(job_count));
  int64_t room = admission_.queued_job_limit_ - counts.queued;
  if (caller_.open_job_limit > 0) room = std::min(room, caller_.open_job_limit - counts.open);
  return std::clamp<int64_t>(room, 0, job_count);
}

}  // namespace flair::orchestrator
