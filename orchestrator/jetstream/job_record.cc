// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/job_record.h"

#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <utility>

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

bool HasEnded(const store::v1::JobRecord& record) {
  const v1::JobState state = record.job().state();
  return state != v1::JOB_STATE_QUEUED && state != v1::JOB_STATE_RUNNING;
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

void ReturnJob(store::v1::JobRecord& record, absl::Time not_before, const std::string& reason) {
  record.mutable_job()->set_state(v1::JOB_STATE_QUEUED);
  record.clear_holder();
  record.set_lost_run_count(std::max(0, record.lost_run_count() - 1));
  if (not_before != absl::InfinitePast()) *record.mutable_not_before_time() = ToTimestamp(not_before);
  if (!reason.empty()) AddEvent(record, v1::JOB_EVENT_KIND_WAITING, reason);
}

void RetryJob(store::v1::JobRecord& record) {
  v1::Job& job = *record.mutable_job();
  job.set_state(v1::JOB_STATE_QUEUED);
  job.clear_error();
  job.clear_error_code();
  job.clear_failure_kind();
  job.clear_end_time();
  record.clear_cancel_requested();
  record.clear_lost_run_count();
  AddEvent(record, v1::JOB_EVENT_KIND_RETRIED, "");
}

JobEnd CancelledEnd(absl::Time time) { return {v1::JOB_STATE_CANCELLED, "", absl::OkStatus(), {}, time}; }

}  // namespace flair::orchestrator
