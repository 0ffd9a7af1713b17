// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs and batches are created in steps, each of which a caller that got no answer may repeat.
#include <fmt/format.h>

#include <algorithm>

#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
// The id under a request's key, which is made to be `id` when there is none.
absl::StatusOr<std::string> JetStreamWorkQueue::IdOfRequest(const std::string& key, const std::string& id) {
  while (true) {
    const absl::StatusOr<uint64_t> made = parts_->requests.Update(key, id, 0);
    if (made.ok()) return id;
    if (!absl::IsAborted(made.status())) return made.status();
    ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> known, IfFound(parts_->requests.Get(key)));
    // What it created has just been deleted.
    if (!known.has_value()) continue;
    return known->value;
  }
}

// Makes the job a user of the artifact and stores that; not when the request made the job before, even if that is being
// deleted.
absl::Status JetStreamWorkQueue::Give(const GivenArtifact& given, const v1::Job& job) {
  ASSIGN_OR_RETURN(const std::optional<RevisedJob> known, IfFound(parts_->GetAnyJob(job.id())));
  if (known.has_value()) return absl::OkStatus();
  const ArtifactUsers::Use use{.artifact_id = given.artifact.ref.id(), .result_key = ""};
  ArtifactUsers::User user;
  user.set_id(job.id());
  user.set_owner_token(OwnerToken(job.owner()));
  RETURN_IF_ERROR(users_.Add(std::span(&use, 1), user).status());
  RETURN_IF_ERROR(given.store->PutAll(std::span(&given.artifact, 1)));
  return given.store->Flush(std::span(&given.artifact.ref, 1));
}

absl::StatusOr<v1::Job> JetStreamWorkQueue::CreateJob(const v1::Job& job, const std::string& request_id,
                                                      const GivenArtifact* given) {
  const std::string key = RequestKey(job.owner(), RequestKind::kJob, request_id, job.id());
  store::v1::JobRecord record;
  while (true) {
    v1::Job named = job;
    ASSIGN_OR_RETURN(const std::string id, IdOfRequest(key, job.id()));
    named.set_id(id);
    if (given != nullptr) RETURN_IF_ERROR(Give(*given, named));
    record = NewRecord(named, request_id, given);
    const absl::StatusOr<uint64_t> made = parts_->jobs.Update(id, runtime::CanonicalBytes(record), 0);
    if (made.ok()) break;
    if (!absl::IsAborted(made.status())) return made.status();
    absl::StatusOr<RevisedJob> known = parts_->GetJob(id);
    if (known.ok()) {
      record = std::move(known->value);
      break;
    }
    if (!absl::IsNotFound(known.status())) return known.status();
    // It is being deleted: the request may create another one.
    RETURN_IF_ERROR(RemoveRequest(key, id));
  }
  // Again for a job that was created before and has never run: its creation may have stopped before this step.
  if (record.job().state() == v1::JOB_STATE_QUEUED && record.job().attempt_count() == 0) {
    RETURN_IF_ERROR(PutIntoQueue(std::span(&record.job(), 1)));
  }
  return record.job();
}

absl::StatusOr<store::v1::BatchRecord> JetStreamWorkQueue::CreateBatch(const store::v1::BatchRecord& batch) {
  const std::string key =
      RequestKey(batch.batch().owner(), RequestKind::kBatch, batch.request_id(), batch.batch().id());
  store::v1::BatchRecord record = batch;
  while (true) {
    ASSIGN_OR_RETURN(const std::string id, IdOfRequest(key, batch.batch().id()));
    record.mutable_batch()->set_id(id);
    const absl::StatusOr<uint64_t> made = parts_->batches.Update(id, runtime::CanonicalBytes(record), 0);
    if (made.ok()) return record;
    if (!absl::IsAborted(made.status())) return made.status();
    absl::StatusOr<RevisedBatch> known = parts_->GetBatch(id);
    if (known.ok()) return std::move(known->value);
    // The last step of its deletion is running.
    if (!absl::IsNotFound(known.status())) return known.status();
  }
}

absl::StatusOr<bool> JetStreamWorkQueue::HasRequest(RequestKind kind, const std::string& owner,
                                                    const std::string& request_id) {
  const absl::Status known = parts_->requests.Get(RequestKey(owner, kind, request_id, "")).status();
  if (!known.ok() && !absl::IsNotFound(known)) return known;
  return known.ok();
}

absl::StatusOr<v1::Batch> JetStreamWorkQueue::AddJobs(const std::string& batch_id, std::span<const v1::Job> jobs,
                                                      bool last) {
  ASSIGN_OR_RETURN(const RevisedBatch before, parts_->GetBatch(batch_id));
  v1::Batch grown = before.value.batch();
  RETURN_IF_ERROR(GrowBatch(jobs, last, grown).status());
  const auto counted = static_cast<size_t>(std::ranges::count_if(
      jobs, [&](const v1::Job& job) { return job.batch_index() < before.value.batch().job_count(); }));
  RETURN_IF_ERROR(CompareSpecs(jobs.first(counted)));
  const std::span<const v1::Job> added = jobs.subspan(counted);
  RETURN_IF_ERROR(AddRecords(batch_id, added));
  RETURN_IF_ERROR(PutIntoQueue(added));
  // Last, so that what a batch counts is there.
  const auto grow = [&](store::v1::BatchRecord& record) { return GrowBatch(jobs, last, *record.mutable_batch()); };
  ASSIGN_OR_RETURN(const RevisedBatch after, parts_->ChangeBatch(batch_id, grow));
  parts_->Notify(Notice::Kind::kBatch, batch_id);
  return after.value.batch();
}

absl::Status JetStreamWorkQueue::AddRecords(const std::string& batch_id, std::span<const v1::Job> jobs) {
  std::vector<Bucket::Change> changes;
  for (const v1::Job& job : jobs) {
    if (job.id() != BatchJobId(batch_id, job.batch_index())) {
      return Internal("the id of job {} does not match its place in batch {}", job.id(), batch_id);
    }
    changes.push_back({job.id(), runtime::CanonicalBytes(NewRecord(job, "")), 0});
  }
  std::vector<v1::Job> there;
  const std::vector<absl::StatusOr<uint64_t>> revisions = parts_->jobs.UpdateAll(changes);
  for (size_t i = 0; i < revisions.size(); ++i) {
    if (absl::IsAborted(revisions[i].status())) {
      there.push_back(jobs[i]);
    } else if (!revisions[i].ok()) {
      return revisions[i].status();
    }
  }
  return CompareSpecs(there);
}

// ALREADY_EXISTS when one of the jobs is there with another spec.
absl::Status JetStreamWorkQueue::CompareSpecs(std::span<const v1::Job> jobs) {
  std::vector<std::string> ids;
  for (const v1::Job& job : jobs) ids.push_back(job.id());
  const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_->jobs.GetAll(ids);
  for (size_t i = 0; i < jobs.size(); ++i) {
    ASSIGN_OR_RETURN(const RevisedJob known, parts_->ParseJob(ids[i], entries[i]));
    RETURN_IF_ERROR(CheckSameSpec(known.value.job(), jobs[i]));
  }
  return absl::OkStatus();
}

absl::Status JetStreamWorkQueue::PutIntoQueue(std::span<const v1::Job> jobs) {
  std::vector<NatsRequest> messages;
  for (const v1::Job& job : jobs) messages.push_back(parts_->QueueMessage(job, job.id()));
  RETURN_IF_ERROR(parts_->streams.PublishEach(messages));
  if (!messages.empty()) Queued(messages.front().subject);
  return absl::OkStatus();
}

// ---- Jobs and batches are cancelled, paused, retried.

absl::Status JetStreamWorkQueue::Cancel(const std::string& job_id, absl::Time now) {
  return repair_.CancelJob(job_id, now);
}

absl::StatusOr<bool> JetStreamWorkQueue::Retry(const std::string& job_id) {
  ASSIGN_OR_RETURN(const RevisedJob failed, parts_->GetJob(job_id));
  const v1::Job& job = failed.value.job();
  if (job.state() != v1::JOB_STATE_FAILED) return false;
  if (!job.batch_id().empty()) {
    ASSIGN_OR_RETURN(const RevisedBatch batch, parts_->GetBatch(job.batch_id()));
    if (batch.value.batch().state() == v1::BATCH_STATE_CANCELLED) return false;
  }
  // The end goes first: with it, the batch would seem to have come to its own. Without it, one that is found later is
  // given back; see BatchRepair.
  RETURN_IF_ERROR(ends_.Remove(job));
  bool retried = false;
  const auto retry = [&](store::v1::JobRecord& record) { return retried = RetryJob(record); };
  ASSIGN_OR_RETURN(const RevisedJob now, parts_->ChangeJob(job_id, retry));
  const v1::Job& waiting = now.value.job();
  if (!retried) {
    // Another process did, and the removed end may have been that of the next run.
    if (!HasEnded(waiting)) return false;
    RETURN_IF_ERROR(ends_.Publish(std::span(&waiting, 1)));
    return false;
  }
  const NatsRequest message = parts_->QueueMessage(waiting, fmt::format("{}-retry-{}", job_id, now.revision));
  RETURN_IF_ERROR(parts_->streams.Publish(message).status());
  Queued(message.subject);
  parts_->NotifyJob(waiting);
  return true;
}

absl::Status JetStreamWorkQueue::SetBatchState(const std::string& batch_id, v1::BatchState state) {
  const auto set = [state](store::v1::BatchRecord& record) {
    return orchestrator::SetBatchState(state, *record.mutable_batch());
  };
  RETURN_IF_ERROR(parts_->ChangeBatch(batch_id, set).status());
  parts_->Notify(Notice::Kind::kBatch, batch_id);
  return absl::OkStatus();
}

absl::Status JetStreamWorkQueue::CancelBatch(const std::string& batch_id, absl::Time now) {
  const auto cancel = [](store::v1::BatchRecord& record) { return orchestrator::CancelBatch(*record.mutable_batch()); };
  ASSIGN_OR_RETURN(const RevisedBatch changed, parts_->ChangeBatch(batch_id, cancel));
  const absl::Status status = repair_.CancelJobs(batch_id, changed.value.batch().job_count(), now);
  // Its messages go when the last of its jobs has ended; see LookOnce.
  ScheduleRepair(batch_id);
  parts_->Notify(Notice::Kind::kBatch, batch_id);
  return status;
}

}  // namespace flair::orchestrator
