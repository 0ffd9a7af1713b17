// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/job_rules.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <functional>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

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

constexpr size_t kLongestName = 32;

std::string WithoutCredentials(const std::string& server) {
  const size_t scheme = server.find("://");
  const size_t host = server.rfind('@');
  if (host == std::string::npos) return server;
  return (scheme == std::string::npos ? "" : server.substr(0, scheme + 3)) + server.substr(host + 1);
}

absl::Status CheckAddress(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls) {
  const std::vector<std::string> servers = QueueServers(config);
  if (servers.empty()) {
    return absl::InvalidArgumentError("queue.address: missing; expected servers such as \"nats://127.0.0.1:4222\"");
  }
  for (const std::string& server : servers) {
    const bool encrypted = server.starts_with("tls://");
    if (!encrypted && !server.starts_with("nats://")) {
      return InvalidArgument("queue.address: \"{}\" is not a server; expected nats://HOST:PORT or tls://HOST:PORT",
                             WithoutCredentials(server).substr(0, 200));
    }
    if (encrypted && (tls == nullptr || tls->authority_path().empty())) {
      return InvalidArgument(
          "queue.address: {} is encrypted, and runtime.tls.authority_path does not name the authority that "
          "signed its certificate",
          WithoutCredentials(server));
    }
  }
  return absl::OkStatus();
}

absl::Status NotHere() {
  return absl::UnimplementedError(
      "queue: this program cannot use NATS servers; flair and flair-orchestrator can (./flair build flair)");
}

NatsForms& Forms() {
  static NatsForms forms{
      [](const auto&, const auto*, const auto&) -> absl::StatusOr<std::unique_ptr<WorkQueue>> { return NotHere(); },
      [](const auto&, const auto*, const auto&) -> absl::StatusOr<std::unique_ptr<ArtifactStore>> {
        return NotHere();
      }};
  return forms;
}

constexpr char kArtifactIsGone[] = "flair/artifact-is-gone";

}  // namespace

bool HasEnded(const v1::Job& job) {
  return job.state() != v1::JOB_STATE_QUEUED && job.state() != v1::JOB_STATE_RUNNING;
}

store::v1::JobRecord NewRecord(const v1::Job& job, const std::string& request_id, const GivenArtifact* given) {
  store::v1::JobRecord record;
  *record.mutable_job() = job;
  record.mutable_job()->set_state(v1::JOB_STATE_QUEUED);
  record.set_request_id(request_id);
  if (given == nullptr) return record;
  AddStageRecords(record, std::span(&given->record, 1));
  record.clear_lost_run_count();
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
      return FailedPrecondition("first_index: {} leaves a gap: batch {} has {} jobs; add from {} on", job.batch_index(),
                                batch.id(), count, count);
    }
    if (!batch.open()) {
      return FailedPrecondition("batch_id: {} is closed with {} jobs; make another batch", batch.id(),
                                batch.job_count());
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
    return FailedPrecondition("batch_id: {} is cancelled; make another batch", batch.id());
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
    return FailedPrecondition("job_id: {} is a job of batch {}; delete the batch", job.id(), job.batch_id());
  }
  if (HasEnded(job)) return absl::OkStatus();
  return FailedPrecondition("job_id: {} {}; cancel it, or wait for its end", job.id(),
                            job.state() == v1::JOB_STATE_QUEUED ? "waits" : "runs");
}

absl::Status CheckDeletable(const v1::Batch& batch, bool ended) {
  if (batch.open()) {
    return FailedPrecondition("batch_id: {} is open: jobs may still be added; close or cancel it", batch.id());
  }
  if (ended) return absl::OkStatus();
  return FailedPrecondition("batch_id: jobs of {} wait or run; cancel it, or wait for its end", batch.id());
}

std::vector<std::string> QueueServers(const config::v1::QueueConfig& config) {
  return absl::StrSplit(config.address(), ',', absl::SkipWhitespace());
}

std::string ShownAddress(const config::v1::QueueConfig& config) {
  std::vector<std::string> servers = QueueServers(config);
  for (std::string& server : servers) server = WithoutCredentials(server);
  return absl::StrJoin(servers, ",");
}

absl::Status CheckQueueConfig(const config::v1::QueueConfig& config, const config::v1::TlsConfig* tls) {
  RETURN_IF_ERROR(CheckAddress(config, tls));
  const std::string& name = config.name();
  const bool good_name =
      std::ranges::all_of(name, [](char c) { return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-'; });
  if (!good_name || name.size() > kLongestName) {
    return InvalidArgument("queue.name: \"{}\" cannot be used; expected at most {} letters, digits and \"-\"",
                           name.substr(0, 80), kLongestName);
  }
  const int replicas = config.replica_count();
  if (replicas != 0 && replicas != 1 && replicas != 3 && replicas != 5) {
    return InvalidArgument("queue.replica_count: {} is not one of 1, 3, 5", replicas);
  }
  if (config.has_lease_seconds() && !(config.lease_seconds() >= 1 && config.lease_seconds() <= 3600)) {
    return InvalidArgument("queue.lease_seconds: {} is out of range [1, 3600]", config.lease_seconds());
  }
  return absl::OkStatus();
}

void UseNats(const NatsForms& forms) { Forms() = forms; }

const NatsForms& Nats() { return Forms(); }

absl::Status ArtifactIsGone(const std::string& artifact_id) {
  absl::Status gone = NotFound("artifact {}: deleted with the last job that had it", artifact_id);
  gone.SetPayload(kArtifactIsGone, absl::Cord());
  return gone;
}

bool IsArtifactGone(const absl::Status& status) { return status.GetPayload(kArtifactIsGone).has_value(); }

std::string JobIdSource::Next() {
  std::lock_guard lock(mutex_);
  last_ = std::max(clock_.Now(), last_ + absl::Microseconds(1));
  const std::string seconds = absl::FormatTime("%Y%m%dT%H%M%S", last_, absl::UTCTimeZone());
  const int64_t microseconds = absl::ToUnixMicros(last_) % 1000000;
  return fmt::format("{}{:06}-{:06x}", seconds, microseconds, random_() & 0xffffffu);
}

std::string BatchJobId(const std::string& batch_id, int64_t index) { return fmt::format("{}-{:08}", batch_id, index); }

}  // namespace flair::orchestrator
