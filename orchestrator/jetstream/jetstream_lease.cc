// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/jetstream_lease.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "orchestrator/jetstream/job_record.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// What a run that only goes away waits for the servers.
constexpr absl::Duration kReturnLimit = absl::Seconds(2);

}  // namespace

JetStreamLease::JetStreamLease(QueueParts& parts, JobEnds& ends, LeaseKeeper& keeper, std::shared_ptr<Hold> hold,
                               RevisedJob record)
    : parts_(parts),
      ends_(ends),
      keeper_(keeper),
      hold_(std::move(hold)),
      job_(record.value.job()),
      history_(record.value.events().begin(), record.value.events().end()),
      lost_run_count_(record.value.lost_run_count() - 1),
      users_(parts),
      record_(std::move(record)) {
  hold_->cancel_requested = record_.value.cancel_requested();
  keeper_.Add(hold_);
}

JetStreamLease::~JetStreamLease() {
  if (!done_ && !hold_->lost) (void)Return(absl::ZeroDuration(), "");
  keeper_.Remove(*hold_);
}

absl::Status JetStreamLease::Refused() {
  hold_->Lose();
  return absl::AbortedError(fmt::format("job {}: another run has it", job_.id()));
}

// Takes over what others wrote into the record, which is no more than that they want the end.
absl::Status JetStreamLease::ReadAgain() {
  absl::StatusOr<RevisedJob> now = parts_.GetJob(job_.id());
  // It was cancelled, and forgotten with its batch.
  if (absl::IsNotFound(now.status())) return Refused();
  if (!now.ok()) return now.status();
  if (now->value.holder() != hold_->holder) return Refused();
  record_ = *std::move(now);
  if (!record_.value.cancel_requested()) return absl::OkStatus();
  hold_->cancel_requested = true;
  hold_->cancellation.Cancel();
  return absl::OkStatus();
}

absl::Status JetStreamLease::Write(const std::function<void(store::v1::JobRecord&)>& change,
                                   const std::function<bool()>& more) {
  while (true) {
    if (hold_->lost || done_) return Refused();
    store::v1::JobRecord changed = record_.value;
    change(changed);
    const absl::StatusOr<uint64_t> revision =
        parts_.jobs.Update(job_.id(), runtime::CanonicalBytes(changed), record_.revision, more);
    if (revision.ok()) {
      record_ = {std::move(changed), *revision};
      return absl::OkStatus();
    }
    if (!absl::IsAborted(revision.status())) return revision.status();
    RETURN_IF_ERROR(ReadAgain());
  }
}

// The last write of the run.
absl::Status JetStreamLease::Close(const std::function<void(store::v1::JobRecord&)>& change,
                                   const std::function<bool()>& more) {
  hold_->closing = true;
  const absl::Status status = Write(change, more);
  hold_->closing = status.ok();
  done_ = status.ok();
  return status;
}

absl::Status JetStreamLease::Announce(std::span<const StageRecord> records) {
  std::lock_guard lock(mutex_);
  return hold_->lost || done_ ? Refused() : BecomeUser(records);
}

// Nobody deletes these artifacts from now on. What is to be used again and has no user is going just now.
absl::Status JetStreamLease::BecomeUser(std::span<const StageRecord> records) {
  std::vector<ArtifactUsers::Use> uses;
  for (const StageRecord& record : records) {
    const std::string& id = record.event.artifact().id();
    if (!id.empty() && !used_.contains(id)) uses.push_back({id, record.result_key});
  }
  if (uses.empty()) return absl::OkStatus();
  ArtifactUsers::User user;
  user.set_id(job_.batch_id().empty() ? job_.id() : job_.batch_id());
  user.set_owner_token(OwnerToken(job_.owner()));
  ASSIGN_OR_RETURN(const std::vector<std::string> unused, users_.Add(uses, user));
  for (const StageRecord& record : records) {
    const std::string& id = record.event.artifact().id();
    const bool reused = record.event.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED;
    if (reused && std::ranges::find(unused, id) != unused.end()) return ArtifactIsGone(id);
  }
  for (const ArtifactUsers::Use& use : uses) used_.insert(use.artifact_id);
  return absl::OkStatus();
}

// What others may find by the artifact: it is there, whoever holds the job now.
absl::Status JetStreamLease::Index(std::span<const StageRecord> records) {
  RETURN_IF_ERROR(BecomeUser(records));
  std::vector<NatsRequest> entries;
  for (const StageRecord& record : records) {
    if (record.result_key.empty() || !record.event.has_artifact()) continue;
    entries.push_back(
        {parts_.index.SubjectOf("result." + record.result_key), runtime::CanonicalBytes(record.event.artifact()), {}});
  }
  return parts_.api.PublishEach(entries);
}

absl::Status JetStreamLease::RecordAll(std::span<const StageRecord> records) {
  if (records.empty()) return absl::OkStatus();
  {
    std::lock_guard lock(mutex_);
    if (hold_->lost || done_) return Refused();
    RETURN_IF_ERROR(Index(records));
    RETURN_IF_ERROR(Write([&](store::v1::JobRecord& job) { AddStageRecords(job, records); },
                          [this] { return !hold_->lost && !hold_->cancellation.cancelled(); }));
  }
  parts_.NotifyJob(job_);
  return absl::OkStatus();
}

absl::Status JetStreamLease::End(const JobEnd& end) {
  v1::Job ended;
  {
    std::lock_guard lock(mutex_);
    if (hold_->lost || done_) return Refused();
    RETURN_IF_ERROR(Index(end.records));
    RETURN_IF_ERROR(Close([&](store::v1::JobRecord& job) { EndJob(job, end); }, [this] { return !hold_->lost; }));
    ended = record_.value.job();
  }
  keeper_.Remove(*hold_);
  // It has ended. What follows from that is repeated by whoever is delivered the message again, if it fails here.
  if (ends_.Publish(std::span(&ended, 1)).ok()) (void)parts_.connection->Publish({hold_->acknowledge, "+ACK", {}});
  parts_.NotifyJob(ended);
  return absl::OkStatus();
}

absl::Status JetStreamLease::Return(absl::Duration delay, const std::string& reason) {
  {
    std::lock_guard lock(mutex_);
    const bool later = delay > absl::ZeroDuration();
    const absl::Time not_before = later ? parts_.clock.Now() + delay : absl::InfinitePast();
    const absl::Duration limit = parts_.clock.Elapsed() + kReturnLimit;
    RETURN_IF_ERROR(Close([&](store::v1::JobRecord& job) { ReturnJob(job, not_before, reason); },
                          [&] { return !hold_->lost && parts_.clock.Elapsed() < limit; }));
  }
  keeper_.Remove(*hold_);
  const std::string refusal =
      delay > absl::ZeroDuration() ? fmt::format("-NAK {{\"delay\": {}}}", absl::ToInt64Nanoseconds(delay)) : "-NAK";
  // Without it, the job waits until its lease would have ended.
  (void)parts_.connection->Publish({hold_->acknowledge, refusal, {}});
  parts_.NotifyJob(job_);
  parts_.NotifyWork(parts_.SubjectOf(job_));
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
