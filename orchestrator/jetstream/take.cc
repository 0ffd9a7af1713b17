// SPDX-License-Identifier: GPL-3.0-or-later
// How a run gets its job: a consumer delivers the message, the run claims the record and holds it by a lease.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/numbers.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/artifact_users.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "orchestrator/jetstream/job_ends.h"
#include "orchestrator/jetstream/lease_keeper.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// How long a run that only releases its job waits for the servers.
constexpr absl::Duration kReturnLimit = absl::Seconds(2);

// A run of a job of a queue in JetStream. Every write replaces the record as this run knows it, so that it fails when
// another run has changed it. Writes go on through times without an answer for as long as the hold lasts.
class JetStreamLease final : public Lease {
 public:
  // `record` says that `hold` has the job. `parts`, `ends` and `keeper` outlive it.
  JetStreamLease(QueueParts& parts, JobEnds& ends, LeaseKeeper& keeper, std::shared_ptr<Hold> hold, RevisedJob record)
      : Lease(record.value),
        parts_(parts),
        ends_(ends),
        keeper_(keeper),
        hold_(std::move(hold)),
        users_(parts),
        record_(std::move(record)) {
    hold_->cancel_requested = record_.value.cancel_requested();
    keeper_.Add(hold_);
  }

  ~JetStreamLease() override {
    if (!done_ && !hold_->lost) (void)Return(absl::ZeroDuration(), "");
    keeper_.Remove(*hold_);
  }

  absl::Status Announce(std::span<const StageRecord> records) override {
    std::lock_guard lock(mutex_);
    return hold_->lost || done_ ? Refused() : BecomeUser(records);
  }

  absl::Status RecordAll(std::span<const StageRecord> records) override {
    if (records.empty()) return absl::OkStatus();
    {
      std::lock_guard lock(mutex_);
      if (hold_->lost || done_) return Refused();
      RETURN_IF_ERROR(Index(records));
      RETURN_IF_ERROR(Write([&](store::v1::JobRecord& job) { AddStageRecords(job, records); },
                            [this] { return !hold_->lost && !hold_->cancellation.cancelled(); }));
    }
    parts_.NotifyJob(job());
    return absl::OkStatus();
  }

  absl::Status End(const JobEnd& end) override {
    v1::Job ended;
    {
      std::lock_guard lock(mutex_);
      if (hold_->lost || done_) return Refused();
      RETURN_IF_ERROR(Index(end.records));
      RETURN_IF_ERROR(Close([&](store::v1::JobRecord& job) { EndJob(job, end); }, [this] { return !hold_->lost; }));
      ended = record_.value.job();
    }
    keeper_.Remove(*hold_);
    // It has ended. If the steps that follow fail here, the process that gets the message again repeats them.
    if (ends_.Publish(std::span(&ended, 1)).ok()) (void)parts_.connection->Publish({hold_->acknowledge, "+ACK", {}});
    parts_.NotifyJob(ended);
    return absl::OkStatus();
  }

  absl::Status Return(absl::Duration delay, const std::string& reason) override {
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
    parts_.NotifyJob(job());
    parts_.Notify(Notice::Kind::kWork, parts_.SubjectOf(job()));
    return absl::OkStatus();
  }

  runtime::Cancellation& cancellation() override { return hold_->cancellation; }
  bool cancel_requested() override { return hold_->cancel_requested; }
  bool lost() override { return hold_->lost; }

 private:
  absl::Status Write(const std::function<void(store::v1::JobRecord&)>& change, const std::function<bool()>& more) {
    while (true) {
      if (hold_->lost || done_) return Refused();
      store::v1::JobRecord changed = record_.value;
      change(changed);
      const absl::StatusOr<uint64_t> revision =
          parts_.jobs.Update(job().id(), runtime::CanonicalBytes(changed), record_.revision, more);
      if (revision.ok()) {
        record_ = {std::move(changed), *revision};
        return absl::OkStatus();
      }
      if (!absl::IsAborted(revision.status())) return revision.status();
      RETURN_IF_ERROR(ReadAgain());
    }
  }

  // The last write of the run.
  absl::Status Close(const std::function<void(store::v1::JobRecord&)>& change, const std::function<bool()>& more) {
    hold_->closing = true;
    const absl::Status status = Write(change, more);
    hold_->closing = status.ok();
    done_ = status.ok();
    return status;
  }

  // Takes over changes by others to the record, which can only be requests to end the job.
  absl::Status ReadAgain() {
    ASSIGN_OR_RETURN(std::optional<RevisedJob> now, IfFound(parts_.GetJob(job().id())));
    // It was cancelled, and deleted with its batch.
    if (!now.has_value()) return Refused();
    if (now->value.holder() != hold_->holder) return Refused();
    record_ = *std::move(now);
    if (!record_.value.cancel_requested()) return absl::OkStatus();
    hold_->cancel_requested = true;
    hold_->cancellation.Cancel();
    return absl::OkStatus();
  }

  absl::Status Refused() {
    hold_->Lose();
    return Aborted("job {}: another run has it", job().id());
  }

  // From now on nobody deletes these artifacts. One that is to be reused and has no user is just being deleted.
  absl::Status BecomeUser(std::span<const StageRecord> records) {
    std::vector<ArtifactUsers::Use> uses;
    for (const StageRecord& record : records) {
      const std::string& id = record.event.artifact().id();
      if (!id.empty() && !used_.contains(id)) uses.push_back({id, record.result_key});
    }
    if (uses.empty()) return absl::OkStatus();
    ArtifactUsers::User user;
    user.set_id(job().batch_id().empty() ? job().id() : job().batch_id());
    user.set_owner_token(OwnerToken(job().owner()));
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
  absl::Status Index(std::span<const StageRecord> records) {
    RETURN_IF_ERROR(BecomeUser(records));
    std::vector<NatsRequest> entries;
    for (const StageRecord& record : records) {
      if (record.result_key.empty() || !record.event.has_artifact()) continue;
      entries.push_back({parts_.index.SubjectOf("result." + record.result_key),
                         runtime::CanonicalBytes(record.event.artifact()),
                         {}});
    }
    return parts_.streams.PublishEach(entries);
  }

  QueueParts& parts_;
  JobEnds& ends_;
  LeaseKeeper& keeper_;
  // Shared with the keeper.
  const std::shared_ptr<Hold> hold_;
  ArtifactUsers users_;

  std::mutex mutex_;
  RevisedJob record_;
  // Artifacts that this run uses.
  std::set<std::string> used_;
  bool done_ = false;
};

// Messages of jobs that need no run, skipped in one go before others have a turn.
constexpr int kPassedOverAtOnce = 100;
// A message without a record is delivered this often, a second apart, before it is dropped.
constexpr int64_t kPatience = 10;

// Holders are called PROCESS/RUN@SEQUENCE after the message that they were delivered.
uint64_t SequenceOf(const std::string& holder) {
  uint64_t sequence = 0;
  const size_t at = holder.rfind('@');
  if (at == std::string::npos || !absl::SimpleAtoi(holder.substr(at + 1), &sequence)) return 0;
  return sequence;
}

}  // namespace

absl::StatusOr<std::unique_ptr<Lease>> JetStreamWorkQueue::Take(const TakeFilter& filter) {
  if (!filter.any) RETURN_IF_ERROR(WantNamed(filter.job_ids));
  int passed_over = 0;
  for (const Consumer& consumer : consumers_.Candidates(filter)) {
    absl::StatusOr<std::unique_ptr<Lease>> lease = TakeFrom(consumer, passed_over);
    if (!lease.ok() || *lease != nullptr) return lease;
    if (passed_over >= kPassedOverAtOnce) {
      NotifyListenerOfWork();
      break;
    }
  }
  return nullptr;
}

absl::StatusOr<std::unique_ptr<Lease>> JetStreamWorkQueue::TakeFrom(const Consumer& consumer, int& passed_over) {
  ASSIGN_OR_RETURN(const v1::BatchState state, BatchStateOf(consumer));
  if (state == v1::BATCH_STATE_PAUSED) return nullptr;
  // Those of a cancelled batch are delivered to be ended. Of one that is cancelled from now on, whoever cancels it sees
  // to the jobs that run.
  const bool cancelled = state == v1::BATCH_STATE_CANCELLED;
  for (; passed_over < kPassedOverAtOnce; ++passed_over) {
    ASSIGN_OR_RETURN(const std::optional<Delivery> delivery, consumers_.Next(consumer));
    if (!delivery.has_value()) return nullptr;
    absl::StatusOr<std::unique_ptr<Lease>> lease = Begin(consumer, *delivery, cancelled);
    if (!lease.ok() || *lease != nullptr) return lease;
  }
  return nullptr;
}

absl::StatusOr<v1::BatchState> JetStreamWorkQueue::BatchStateOf(const Consumer& consumer) {
  if (consumer.batch_id.empty()) return v1::BATCH_STATE_ACTIVE;
  ASSIGN_OR_RETURN(const std::optional<RevisedBatch> batch, IfFound(parts_->GetBatch(consumer.batch_id)));
  if (!batch.has_value()) return v1::BATCH_STATE_ACTIVE;
  return batch->value.batch().state();
}

void JetStreamWorkQueue::Acknowledge(const Delivery& delivery, const std::string& how) {
  // When it is lost, the message comes again.
  (void)parts_->connection->Publish({delivery.acknowledge, how, {}});
}

// The right to run the job of a message; null when it needs no run.
absl::StatusOr<std::unique_ptr<Lease>> JetStreamWorkQueue::Begin(const Consumer& consumer, const Delivery& delivery,
                                                                 bool batch_cancelled) {
  while (true) {
    absl::StatusOr<RevisedJob> job = parts_->GetJob(delivery.job_id);
    if (absl::IsNotFound(job.status())) {
      Acknowledge(delivery, delivery.delivery_count < kPatience ? "-NAK {\"delay\": 1000000000}" : "+TERM");
      return nullptr;
    }
    if (!job.ok()) return job.status();
    ASSIGN_OR_RETURN(const bool may_run, MayRun(delivery, job->value, batch_cancelled));
    if (!may_run) return nullptr;
    auto hold = std::make_shared<Hold>();
    hold->job_id = delivery.job_id;
    hold->holder = fmt::format("{}/{}@{}", process_, next_run_++, delivery.sequence);
    hold->acknowledge = delivery.acknowledge;
    const bool taken_over = !job->value.holder().empty();
    BeginRun(job->value, hold->holder);
    const absl::StatusOr<uint64_t> revision =
        parts_->jobs.Update(delivery.job_id, runtime::CanonicalBytes(job->value), job->revision);
    if (absl::IsAborted(revision.status())) continue;
    if (!revision.ok()) return revision.status();
    job->revision = *revision;
    consumers_.HadTurn(consumer);
    if (taken_over) parts_->Notify(Notice::Kind::kHold, delivery.job_id);
    return std::make_unique<JetStreamLease>(*parts_, ends_, keeper_, std::move(hold), *std::move(job));
  }
}

// Acknowledges the message and repeats what may be missing when the job of it needs no run.
absl::StatusOr<bool> JetStreamWorkQueue::MayRun(const Delivery& delivery, const store::v1::JobRecord& record,
                                                bool batch_cancelled) {
  if (HasEnded(record)) {
    RETURN_IF_ERROR(ends_.Publish(std::span(&record.job(), 1)));
    Acknowledge(delivery, "+ACK");
    return false;
  }
  ASSIGN_OR_RETURN(const bool elsewhere, OtherMessageRuns(delivery, record));
  if (elsewhere) {
    Acknowledge(delivery, "+ACK");
    return false;
  }
  if (!record.cancel_requested() && !batch_cancelled) return true;
  const auto end = [&](store::v1::JobRecord& now) {
    if (HasEnded(now)) return false;
    EndJob(now, CancelledEnd(parts_->clock.Now()));
    return true;
  };
  ASSIGN_OR_RETURN(const RevisedJob ended, parts_->ChangeJob(delivery.job_id, end));
  RETURN_IF_ERROR(ends_.Publish(std::span(&ended.value.job(), 1)));
  Acknowledge(delivery, "+ACK");
  parts_->NotifyJob(ended.value.job());
  return false;
}

// A job may have two messages after a repair. The one whose run has the job stays.
absl::StatusOr<bool> JetStreamWorkQueue::OtherMessageRuns(const Delivery& delivery,
                                                          const store::v1::JobRecord& record) {
  const uint64_t sequence = SequenceOf(record.holder());
  if (record.job().state() != v1::JOB_STATE_RUNNING || sequence == 0 || sequence == delivery.sequence) return false;
  ASSIGN_OR_RETURN(const std::optional<StoredMessage> found,
                   IfFound(parts_->streams.Get(parts_->names.queue_stream(), sequence)));
  return found.has_value();
}

// Gives the jobs that wait, and are asked for by their ids, a message that is delivered to who asks so.
absl::Status JetStreamWorkQueue::WantNamed(const std::set<std::string>& job_ids) {
  for (const std::string& id : job_ids) {
    ASSIGN_OR_RETURN(const std::optional<RevisedJob> job, IfFound(parts_->GetJob(id)));
    if (!job.has_value()) continue;
    const v1::Job& wanted = job->value.job();
    if (wanted.state() != v1::JOB_STATE_QUEUED) continue;
    const std::string subject = parts_->names.Named(OwnerToken(wanted.owner()), id);
    RETURN_IF_ERROR(
        parts_->streams.Publish(WithMessageId(subject, id, fmt::format("{}-named-{}", id, job->revision))).status());
    consumers_.Want(subject);
  }
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
