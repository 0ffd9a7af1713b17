// SPDX-License-Identifier: GPL-3.0-or-later
// How a job comes to a run: a consumer hands out its message, and the run claims the record.
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

// Holders are called PROCESS/RUN@SEQUENCE after the message that they were handed.
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
  for (const Lane& lane : lanes_.Candidates(filter)) {
    absl::StatusOr<std::unique_ptr<Lease>> lease = TakeFrom(lane, passed_over);
    if (!lease.ok() || *lease != nullptr) return lease;
    if (passed_over >= kPassedOverAtOnce) {
      TellWork();
      break;
    }
  }
  return nullptr;
}

absl::StatusOr<std::unique_ptr<Lease>> JetStreamWorkQueue::TakeFrom(const Lane& lane, int& passed_over) {
  ASSIGN_OR_RETURN(const v1::BatchState state, StateOfLane(lane));
  if (state == v1::BATCH_STATE_PAUSED) return nullptr;
  // Those of a cancelled batch are handed out to be ended. Of one that is cancelled from now on, whoever cancels it
  // sees to the jobs that run.
  const bool cancelled = state == v1::BATCH_STATE_CANCELLED;
  for (; passed_over < kPassedOverAtOnce; ++passed_over) {
    ASSIGN_OR_RETURN(const std::optional<Handed> handed, lanes_.Next(lane));
    if (!handed.has_value()) return nullptr;
    absl::StatusOr<std::unique_ptr<Lease>> lease = Begin(lane, *handed, cancelled);
    if (!lease.ok() || *lease != nullptr) return lease;
  }
  return nullptr;
}

absl::StatusOr<v1::BatchState> JetStreamWorkQueue::StateOfLane(const Lane& lane) {
  if (lane.batch_id.empty()) return v1::BATCH_STATE_ACTIVE;
  const absl::StatusOr<RevisedBatch> batch = parts_->GetBatch(lane.batch_id);
  if (absl::IsNotFound(batch.status())) return v1::BATCH_STATE_ACTIVE;
  if (!batch.ok()) return batch.status();
  return batch->value.batch().state();
}

void JetStreamWorkQueue::Acknowledge(const Handed& handed, const std::string& how) {
  // When it is lost, the message comes again.
  (void)parts_->connection->Publish({handed.acknowledge, how, {}});
}

// The right to run the job of a message; null when it needs no run.
absl::StatusOr<std::unique_ptr<Lease>> JetStreamWorkQueue::Begin(const Lane& lane, const Handed& handed,
                                                                 bool batch_cancelled) {
  while (true) {
    absl::StatusOr<RevisedJob> job = parts_->GetJob(handed.job_id);
    if (absl::IsNotFound(job.status())) {
      Acknowledge(handed, handed.delivery_count < kPatience ? "-NAK {\"delay\": 1000000000}" : "+TERM");
      return nullptr;
    }
    if (!job.ok()) return job.status();
    ASSIGN_OR_RETURN(const bool may_run, MayRun(handed, job->value, batch_cancelled));
    if (!may_run) return nullptr;
    auto hold = std::make_shared<Hold>();
    hold->job_id = handed.job_id;
    hold->holder = fmt::format("{}/{}@{}", process_, next_run_++, handed.sequence);
    hold->acknowledge = handed.acknowledge;
    const bool taken_over = !job->value.holder().empty();
    BeginRun(job->value, hold->holder);
    const absl::StatusOr<uint64_t> revision =
        parts_->jobs.Update(handed.job_id, runtime::CanonicalBytes(job->value), job->revision);
    if (absl::IsAborted(revision.status())) continue;
    if (!revision.ok()) return revision.status();
    job->revision = *revision;
    lanes_.HadTurn(lane);
    if (taken_over) parts_->TellHolder(handed.job_id);
    return std::make_unique<JetStreamLease>(*parts_, ends_, *keeper_, std::move(hold), *std::move(job));
  }
}

// Acknowledges the message and repeats what may be missing when the job of it needs no run.
absl::StatusOr<bool> JetStreamWorkQueue::MayRun(const Handed& handed, const store::v1::JobRecord& record,
                                                bool batch_cancelled) {
  if (HasEnded(record)) {
    RETURN_IF_ERROR(ends_.Publish(std::span(&record.job(), 1)));
    Acknowledge(handed, "+ACK");
    return false;
  }
  ASSIGN_OR_RETURN(const bool elsewhere, OtherMessageRuns(handed, record));
  if (elsewhere) {
    Acknowledge(handed, "+ACK");
    return false;
  }
  if (!record.cancel_requested() && !batch_cancelled) return true;
  const absl::StatusOr<RevisedJob> ended =
      parts_->ChangeJob(handed.job_id, [&](store::v1::JobRecord& now) -> absl::StatusOr<bool> {
        if (HasEnded(now)) return false;
        EndJob(now, CancelledEnd(parts_->clock.Now()));
        return true;
      });
  if (!ended.ok()) return ended.status();
  RETURN_IF_ERROR(ends_.Publish(std::span(&ended->value.job(), 1)));
  Acknowledge(handed, "+ACK");
  parts_->TellOfJob(ended->value.job());
  return false;
}

// A job may have two messages after a repair. The one whose run has the job stays.
absl::StatusOr<bool> JetStreamWorkQueue::OtherMessageRuns(const Handed& handed, const store::v1::JobRecord& record) {
  const uint64_t sequence = SequenceOf(record.holder());
  if (record.job().state() != v1::JOB_STATE_RUNNING || sequence == 0 || sequence == handed.sequence) return false;
  const absl::Status found =
      parts_->api.Call("STREAM.MSG.GET." + parts_->names.queue_stream(), nlohmann::json{{"seq", sequence}}).status();
  if (absl::IsNotFound(found)) return false;
  if (!found.ok()) return found;
  return true;
}

// Gives the jobs that wait, and are asked for by their ids, a message that is handed out to who asks so.
absl::Status JetStreamWorkQueue::WantNamed(const std::set<std::string>& job_ids) {
  for (const std::string& id : job_ids) {
    const absl::StatusOr<RevisedJob> job = parts_->GetJob(id);
    if (absl::IsNotFound(job.status())) continue;
    if (!job.ok()) return job.status();
    const v1::Job& wanted = job->value.job();
    if (wanted.state() != v1::JOB_STATE_QUEUED) continue;
    const std::string lane = parts_->names.Named(OwnerToken(wanted.owner()), id);
    const NatsRequest message{lane, id, {{"Nats-Msg-Id", fmt::format("{}-named-{}", id, job->revision)}}};
    ASSIGN_OR_RETURN(const StoredAck ack, parts_->api.Publish(message));
    lanes_.Want(lane);
  }
  return absl::OkStatus();
}

}  // namespace flair::orchestrator
