// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/job_rules.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <functional>

#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

google::protobuf::Timestamp ToTimestamp(absl::Time time) {
  return google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(time));
}

void AddEvent(store::v1::JobRecord& record, v1::JobEvent event) {
  event.set_job_id(record.job().id());
  event.set_sequence(record.events_size() + 1);
  *record.add_events() = std::move(event);
}

void AddEvent(store::v1::JobRecord& record, v1::JobEventKind kind, const std::string& message) {
  v1::JobEvent event;
  event.set_kind(kind);
  event.set_message(message);
  event.set_state(record.job().state());
  AddEvent(record, std::move(event));
}

// Replaces what the stage had; in stage order.
void Attach(store::v1::JobRecord& record, int stage, const v1::ArtifactRef& artifact) {
  auto& artifacts = *record.mutable_job()->mutable_artifacts();
  auto& stages = *record.mutable_artifact_stages();
  int place = 0;
  while (place < stages.size() && stages.Get(place) < stage) ++place;
  if (place < stages.size() && stages.Get(place) == stage) {
    *artifacts.Mutable(place) = artifact;
    return;
  }
  *artifacts.Add() = artifact;
  stages.Add(stage);
  for (int i = stages.size() - 1; i > place; --i) {
    artifacts.SwapElements(i, i - 1);
    stages.SwapElements(i, i - 1);
  }
}

}  // namespace

bool HasEnded(const v1::Job& job) {
  return job.state() != v1::JOB_STATE_QUEUED && job.state() != v1::JOB_STATE_RUNNING;
}

store::v1::JobRecord NewRecord(const v1::Job& job, const std::string& request_id) {
  store::v1::JobRecord record;
  *record.mutable_job() = job;
  record.mutable_job()->set_state(v1::JOB_STATE_QUEUED);
  record.set_request_id(request_id);
  return record;
}

void BeginRun(store::v1::JobRecord& record, const std::string& holder) {
  v1::Job& job = *record.mutable_job();
  job.set_state(v1::JOB_STATE_RUNNING);
  job.set_attempt_count(job.attempt_count() + 1);
  record.set_lost_run_count(record.lost_run_count() + 1);
  record.set_holder(holder);
  record.clear_not_before_time();
}

void AddStageRecords(store::v1::JobRecord& record, std::span<const StageRecord> stages) {
  for (const StageRecord& stage : stages) {
    record.mutable_job()->set_stage(stage.event.stage());
    if (stage.event.has_artifact()) {
      Attach(record, stage.stage_index, stage.event.artifact());
      // This run, which counts as lost until it says otherwise.
      record.set_lost_run_count(1);
    }
    AddEvent(record, stage.event);
  }
}

void EndJob(store::v1::JobRecord& record, const JobEnd& end) {
  AddStageRecords(record, end.records);
  v1::Job& job = *record.mutable_job();
  job.set_state(end.state);
  job.set_stage(end.stage);
  job.set_error(std::string(end.error.message()));
  job.set_error_code(static_cast<int>(end.error.code()));
  job.set_failure_kind(end.failure_kind);
  *job.mutable_end_time() = ToTimestamp(end.time);
  record.clear_holder();
  record.clear_not_before_time();
  AddEvent(record, v1::JOB_EVENT_KIND_ENDED, job.error());
}

JobEnd CancelledEnd(absl::Time time) { return {v1::JOB_STATE_CANCELLED, "", absl::OkStatus(), {}, time}; }

void ReturnJob(store::v1::JobRecord& record, absl::Time not_before, const std::string& reason) {
  record.mutable_job()->set_state(v1::JOB_STATE_QUEUED);
  record.clear_holder();
  record.set_lost_run_count(std::max(0, record.lost_run_count() - 1));
  if (not_before != absl::InfinitePast()) *record.mutable_not_before_time() = ToTimestamp(not_before);
  if (!reason.empty()) AddEvent(record, v1::JOB_EVENT_KIND_WAITING, reason);
}

bool CancelJob(store::v1::JobRecord& record, absl::Time now) {
  if (HasEnded(record) || record.cancel_requested()) return false;
  record.set_cancel_requested(true);
  if (record.job().state() == v1::JOB_STATE_QUEUED) EndJob(record, CancelledEnd(now));
  return true;
}

bool RetryJob(store::v1::JobRecord& record) {
  v1::Job& job = *record.mutable_job();
  if (job.state() != v1::JOB_STATE_FAILED) return false;
  job.set_state(v1::JOB_STATE_QUEUED);
  job.clear_error();
  job.clear_error_code();
  job.clear_failure_kind();
  job.clear_end_time();
  record.clear_cancel_requested();
  record.clear_lost_run_count();
  AddEvent(record, v1::JOB_EVENT_KIND_RETRIED, "");
  return true;
}

absl::StatusOr<bool> GrowBatch(std::span<const v1::Job> jobs, bool last, v1::Batch& batch) {
  int64_t count = batch.job_count();
  for (const v1::Job& job : jobs) {
    if (job.batch_index() < count) continue;
    if (job.batch_index() > count) {
      return absl::FailedPreconditionError(
          fmt::format("first_index: {} leaves a gap: batch {} has {} jobs; add from {} on", job.batch_index(),
                      batch.id(), count, count));
    }
    if (!batch.open()) {
      return absl::FailedPreconditionError(
          fmt::format("batch_id: {} is closed with {} jobs; make another batch", batch.id(), batch.job_count()));
    }
    ++count;
  }
  const bool open = batch.open() && !last;
  if (count == batch.job_count() && open == batch.open()) return false;
  batch.set_job_count(static_cast<int>(count));
  batch.set_open(open);
  return true;
}

absl::Status CheckSameSpec(const v1::Job& known, const v1::Job& job) {
  if (runtime::CanonicalBytes(known.spec()) == runtime::CanonicalBytes(job.spec())) return absl::OkStatus();
  return absl::AlreadyExistsError(fmt::format("specs: place {} of batch {} has another spec; make another batch",
                                              job.batch_index(), job.batch_id()));
}

absl::StatusOr<bool> SetBatchState(v1::BatchState state, v1::Batch& batch) {
  if (batch.state() == v1::BATCH_STATE_CANCELLED) {
    if (state != v1::BATCH_STATE_ACTIVE) return false;
    return absl::FailedPreconditionError(fmt::format("batch_id: {} is cancelled; make another batch", batch.id()));
  }
  if (batch.state() == state) return false;
  batch.set_state(state);
  return true;
}

bool CancelBatch(v1::Batch& batch) {
  if (batch.state() == v1::BATCH_STATE_CANCELLED && !batch.open()) return false;
  batch.set_state(v1::BATCH_STATE_CANCELLED);
  batch.set_open(false);
  return true;
}

void SetCounts(const EndCounts& ends, v1::Batch& batch) {
  for (const auto& [end, count] : ends) {
    const auto [state, kind] = end;
    if (state == v1::JOB_STATE_SUCCEEDED) batch.set_succeeded_count(batch.succeeded_count() + count);
    if (state == v1::JOB_STATE_CANCELLED) batch.set_cancelled_count(batch.cancelled_count() + count);
    if (state != v1::JOB_STATE_FAILED) continue;
    batch.set_failed_count(batch.failed_count() + count);
    v1::FailureCount& failure = *batch.add_failures();
    failure.set_kind(kind);
    failure.set_job_count(count);
  }
  std::ranges::stable_sort(*batch.mutable_failures(), std::greater(), &v1::FailureCount::job_count);
  const int ended = batch.succeeded_count() + batch.failed_count() + batch.cancelled_count();
  // Of an open batch, jobs may have ended that it does not count yet.
  batch.set_open_count(std::max(0, batch.job_count() - ended));
}

absl::Status CheckDeletable(const v1::Job& job) {
  if (!job.batch_id().empty()) {
    return absl::FailedPreconditionError(
        fmt::format("job_id: {} is a job of batch {}; delete the batch", job.id(), job.batch_id()));
  }
  if (HasEnded(job)) return absl::OkStatus();
  return absl::FailedPreconditionError(fmt::format("job_id: {} {}; cancel it, or wait for its end", job.id(),
                                                   job.state() == v1::JOB_STATE_QUEUED ? "waits" : "runs"));
}

absl::Status CheckDeletable(const v1::Batch& batch, bool ended) {
  if (batch.open()) {
    return absl::FailedPreconditionError(
        fmt::format("batch_id: {} is open: jobs may still be added; close or cancel it", batch.id()));
  }
  if (ended) return absl::OkStatus();
  return absl::FailedPreconditionError(
      fmt::format("batch_id: jobs of {} wait or run; cancel it, or wait for its end", batch.id()));
}

}  // namespace flair::orchestrator
