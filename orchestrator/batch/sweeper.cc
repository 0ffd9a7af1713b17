// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "orchestrator/batch/repeater.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Jobs and batches that are looked at, and jobs of a batch that are deleted, in one step.
constexpr size_t kEntriesPerStep = 100;
constexpr int kJobsPerStep = 400;

constexpr absl::Duration kPause = absl::Milliseconds(100);
constexpr absl::Duration kShortestRest = absl::Seconds(1);
constexpr absl::Duration kLongestRest = absl::Minutes(1);

}  // namespace

absl::Duration Sweeper::StepAndPause() {
  const absl::StatusOr<Deleted> step = Step();
  // Once per outage.
  if (!step.ok() && !failed_) {
    logger_.warn("cannot delete what has ended: {}; will keep trying", std::string(step.status().message()));
  }
  failed_ = !step.ok();
  if (step.ok() && !step->done) return kPause;
  // What goes is gone within a twentieth of the time that it was kept.
  return keep_ended_.has_value() ? std::clamp(*keep_ended_ / 20, kShortestRest, kLongestRest) : kLongestRest;
}

absl::StatusOr<Deleted> Sweeper::Step() {
  absl::StatusOr<Deleted> deleted = queue_.FinishDeletions(artifacts_);
  if (!deleted.ok() || !keep_ended_.has_value()) return deleted;
  ASSIGN_OR_RETURN(const EndedPage page,
                   queue_.EndedBefore(clock_.Now() - *keep_ended_, next_, static_cast<int>(kEntriesPerStep)));
  RETURN_IF_ERROR(DeleteAll(page, *deleted));
  // A page that was left before its end is looked at again.
  if (deleted->done) next_ = page.next;
  deleted->done = deleted->done && next_.empty() && page.job_ids.size() < kEntriesPerStep;
  return deleted;
}

absl::Status Sweeper::DeleteAll(const EndedPage& page, Deleted& deleted) {
  const auto add = [&](const absl::StatusOr<Deleted>& some) {
    // Another process was faster, or somebody wants it again.
    if (absl::IsNotFound(some.status()) || absl::IsFailedPrecondition(some.status())) return absl::OkStatus();
    if (!some.ok()) return some.status();
    deleted.job_count += some->job_count;
    deleted.artifact_count += some->artifact_count;
    deleted.done = deleted.done && some->done;
    return absl::OkStatus();
  };
  for (const std::string& id : page.job_ids) RETURN_IF_ERROR(add(queue_.DeleteJob(id, artifacts_)));
  for (const std::string& id : page.batch_ids) {
    if (deleted.job_count >= kJobsPerStep) deleted.done = false;
    if (!deleted.done) return absl::OkStatus();
    RETURN_IF_ERROR(add(queue_.DeleteBatch(id, kJobsPerStep, artifacts_)));
  }
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
