// SPDX-License-Identifier: GPL-3.0-or-later
// How a job comes to a run: a consumer delivers its message, and the run claims the record.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "absl/strings/numbers.h"
#include "orchestrator/jetstream/jetstream_lease.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "orchestrator/jetstream/job_record.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Messages of jobs that need no run, passed over before others have a turn.
constexpr int kPassedOverAtOnce = 100;
// A message whose record is not there is shown so often, a second apart, before it is thrown away.
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
  if (!filter.any) {
    RETURN_IF_ERROR(WantNamed(filter.job_ids));
  }
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
  const absl::StatusOr<RevisedBatch> batch = parts_->GetBatch(consumer.batch_id);
  if (absl::IsNotFound(batch.status())) return v1::BATCH_STATE_ACTIVE;
  if (!batch.ok()) return batch.status();
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
    if (taken_over) parts_->NotifyHolder(delivery.job_id);
    return std::make_unique<JetStreamLease>(*parts_, ends_, *keeper_, std::move(hold), *std::move(job));
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
  const absl::StatusOr<RevisedJob> ended =
      parts_->ChangeJob(delivery.job_id, [&](store::v1::JobRecord& now) -> absl::StatusOr<bool> {
        if (HasEnded(now)) return false;
        EndJob(now, CancelledEnd(parts_->clock.Now()));
        return true;
      });
  if (!ended.ok()) return ended.status();
  RETURN_IF_ERROR(ends_.Publish(std::span(&ended->value.job(), 1)));
  Acknowledge(delivery, "+ACK");
  parts_->NotifyJob(ended->value.job());
  return false;
}

// A job may have two messages after a repair. The one whose run has the job stays.
absl::StatusOr<bool> JetStreamWorkQueue::OtherMessageRuns(const Delivery& delivery,
                                                          const store::v1::JobRecord& record) {
  const uint64_t sequence = SequenceOf(record.holder());
  if (record.job().state() != v1::JOB_STATE_RUNNING || sequence == 0 || sequence == delivery.sequence) return false;
  const absl::Status found =
      parts_->api.Call("STREAM.MSG.GET." + parts_->names.queue_stream(), nlohmann::json{{"seq", sequence}}).status();
  if (absl::IsNotFound(found)) return false;
  if (!found.ok()) return found;
  return true;
}

// Gives the jobs that wait, and are asked for by their ids, a message that is delivered to who asks so.
absl::Status JetStreamWorkQueue::WantNamed(const std::set<std::string>& job_ids) {
  for (const std::string& id : job_ids) {
    const absl::StatusOr<RevisedJob> job = parts_->GetJob(id);
    if (absl::IsNotFound(job.status())) continue;
    if (!job.ok()) return job.status();
    const v1::Job& wanted = job->value.job();
    if (wanted.state() != v1::JOB_STATE_QUEUED) continue;
    const std::string subject = parts_->names.Named(OwnerToken(wanted.owner()), id);
    const NatsRequest message{subject, id, {{"Nats-Msg-Id", fmt::format("{}-named-{}", id, job->revision)}}};
    RETURN_IF_ERROR(parts_->api.Publish(message).status());
    consumers_.Want(subject);
  }
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
