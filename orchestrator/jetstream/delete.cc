// SPDX-License-Identifier: GPL-3.0-or-later
// Deletes ended jobs and batches, in steps that any process may repeat. For a job without a batch: a note that it is
// being deleted (kDeleting in the bucket of requests), which hides it; then its artifacts, its request, its record and
// the note go. For a batch: it is cancelled, so that none of its jobs runs again; its jobs go from the last place on,
// some at a time, and their artifacts are noted (doomed.BATCH.PLACE in the index); when no job is left, those artifacts
// go, then the batch.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Jobs whose records are deleted together. Never change it: the places of notes depend on it.
constexpr int64_t kForgottenAtOnce = 200;

constexpr int kNotesAtOnce = 1000;

// The state that the note records.
constexpr char kJobNote[] = "job";
constexpr char kBatchNote[] = "batch";

std::string TombstoneKey(const std::string& batch_id, int64_t first) {
  return fmt::format("doomed.{}.{}", batch_id, first);
}

// All artifacts of the job, from all of its runs.
std::vector<std::string> ArtifactsOf(std::span<const store::v1::JobRecord> records) {
  std::set<std::string> ids;
  for (const store::v1::JobRecord& record : records) {
    for (const v1::ArtifactRef& artifact : record.job().artifacts()) ids.insert(artifact.id());
    for (const v1::JobEvent& event : record.events()) {
      if (event.has_artifact()) ids.insert(event.artifact().id());
    }
  }
  return {ids.begin(), ids.end()};
}

}  // namespace

// The key of the note that a job or batch is being deleted.
std::string JetStreamWorkQueue::NoteKey(const std::string& owner, const std::string& id) const {
  return OwnerToken(owner) + "." + kDeleting + "." + id;
}

// Removes a key of the bucket of requests if it has that value; whatever it has when `id` is empty.
absl::Status JetStreamWorkQueue::RemoveRequest(const std::string& key, const std::string& id) {
  ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> entry, IfFound(parts_->requests.Get(key)));
  if (!entry.has_value() || (!id.empty() && entry->value != id)) return absl::OkStatus();
  return parts_->requests.Remove({key, entry->revision}).status();
}

absl::Status JetStreamWorkQueue::RemoveNote(const std::string& owner, const std::string& id) {
  return RemoveRequest(NoteKey(owner, id), "");
}

// Deletes those of the artifacts whose only user is `user_id`.
absl::StatusOr<int64_t> JetStreamWorkQueue::DeleteArtifacts(std::span<const std::string> ids,
                                                            const std::string& user_id, ArtifactStore& artifacts) {
  if (ids.empty()) return 0;
  ASSIGN_OR_RETURN(const int64_t mark, artifacts.Mark());
  ASSIGN_OR_RETURN(const std::vector<std::string> free, users_.Remove(ids, user_id));
  return artifacts.Delete(free, mark);
}

absl::StatusOr<Deleted> JetStreamWorkQueue::DeleteJob(const std::string& job_id, ArtifactStore& artifacts) {
  ASSIGN_OR_RETURN(const RevisedJob job, parts_->GetJob(job_id));
  RETURN_IF_ERROR(CheckDeletable(job.value.job()));
  const std::string& owner = job.value.job().owner();
  RETURN_IF_ERROR(parts_->requests.Put(NoteKey(owner, job_id), kJobNote).status());
  return ForgetJob(job_id, owner, artifacts);
}

// Of a job with a note.
absl::StatusOr<Deleted> JetStreamWorkQueue::ForgetJob(const std::string& job_id, const std::string& owner,
                                                      ArtifactStore& artifacts) {
  Deleted deleted{.done = true};
  const auto hide = [](store::v1::JobRecord& record) -> absl::StatusOr<bool> {
    RETURN_IF_ERROR(CheckDeletable(record.job()));
    record.set_deleting(true);
    return true;
  };
  const absl::Status hidden = parts_->ChangeJob(job_id, hide).status();
  // Retried just now.
  if (absl::IsFailedPrecondition(hidden)) {
    RETURN_IF_ERROR(RemoveNote(owner, job_id));
    return hidden;
  }
  if (!hidden.ok() && !absl::IsNotFound(hidden)) return hidden;
  ASSIGN_OR_RETURN(const std::optional<RevisedJob> job, IfFound(parts_->GetAnyJob(job_id)));
  if (job.has_value()) {
    const store::v1::JobRecord& record = job->value;
    ASSIGN_OR_RETURN(deleted.artifact_count, DeleteArtifacts(ArtifactsOf(std::span(&record, 1)), job_id, artifacts));
    RETURN_IF_ERROR(RemoveRequest(RequestKey(owner, RequestKind::kJob, record.request_id(), job_id), job_id));
    ASSIGN_OR_RETURN(const bool removed, parts_->jobs.Remove({job_id, job->revision}));
    deleted.job_count = removed ? 1 : 0;
  }
  RETURN_IF_ERROR(RemoveNote(owner, job_id));
  return deleted;
}

// A batch that is being deleted.
absl::StatusOr<RevisedBatch> JetStreamWorkQueue::BeginToDelete(const std::string& batch_id) {
  absl::StatusOr<RevisedBatch> batch = parts_->GetBatch(batch_id);
  if (!batch.ok() || batch->value.has_deleted_job_count()) return batch;
  ASSIGN_OR_RETURN(const bool ended, BatchHasEnded(batch_id));
  return parts_->ChangeBatch(batch_id, [&](store::v1::BatchRecord& record) -> absl::StatusOr<bool> {
    v1::Batch& now = *record.mutable_batch();
    RETURN_IF_ERROR(CheckDeletable(now, ended));
    if (record.has_deleted_job_count()) return false;
    orchestrator::CancelBatch(now);
    record.set_deleted_job_count(now.job_count());
    return true;
  });
}

absl::StatusOr<Deleted> JetStreamWorkQueue::DeleteBatch(const std::string& batch_id, int job_limit,
                                                        ArtifactStore& artifacts) {
  ASSIGN_OR_RETURN(RevisedBatch batch, BeginToDelete(batch_id));
  const int64_t all = batch.value.deleted_job_count();
  Deleted deleted;
  // Those that an earlier, interrupted deletion may have left.
  int64_t left = batch.value.batch().job_count();
  if (left < all) {
    ASSIGN_OR_RETURN(deleted.job_count, ForgetPlaces(batch_id, left, std::min(all, left + kForgottenAtOnce)));
  }
  while (left > 0 && deleted.job_count < job_limit) {
    const int64_t end = left;
    left = std::max<int64_t>(0, end - kForgottenAtOnce);
    const auto shrink = [left](store::v1::BatchRecord& record) {
      if (record.batch().job_count() <= left) return false;
      record.mutable_batch()->set_job_count(static_cast<int>(left));
      return true;
    };
    ASSIGN_OR_RETURN(batch, parts_->ChangeBatch(batch_id, shrink));
    ASSIGN_OR_RETURN(const int64_t count, ForgetPlaces(batch_id, left, end));
    deleted.job_count += count;
  }
  if (left == 0 && deleted.job_count < job_limit) {
    RETURN_IF_ERROR(DeleteTombstoned(batch_id, all, job_limit - deleted.job_count, artifacts, deleted));
    if (deleted.done) RETURN_IF_ERROR(ForgetBatch(batch.value));
  }
  parts_->Notify(Notice::Kind::kBatch, batch_id);
  return deleted;
}

// Deletes the jobs at these places, and notes their artifacts. Returns how many there were.
absl::StatusOr<int64_t> JetStreamWorkQueue::ForgetPlaces(const std::string& batch_id, int64_t first, int64_t end) {
  int64_t forgotten = 0;
  std::vector<std::string> ids;
  for (int64_t i = first; i < end; ++i) ids.push_back(BatchJobId(batch_id, i));
  // Repeat for those that a run, which continues in spite of this, has changed meanwhile.
  while (!ids.empty()) {
    std::vector<store::v1::JobRecord> records;
    std::vector<Bucket::Revision> revisions;
    const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_->jobs.GetAll(ids);
    for (size_t i = 0; i < ids.size(); ++i) {
      ASSIGN_OR_RETURN(std::optional<RevisedJob> job, IfFound(parts_->ParseJob(ids[i], entries[i])));
      if (!job.has_value()) continue;
      revisions.push_back({ids[i], job->revision});
      records.push_back(std::move(job->value));
    }
    store::v1::ArtifactIds tombstones;
    for (std::string& id : ArtifactsOf(records)) tombstones.add_ids(std::move(id));
    const absl::Status noted =
        parts_->index.Update(TombstoneKey(batch_id, first), runtime::CanonicalBytes(tombstones), 0).status();
    // An earlier deletion that came this far noted as much or more.
    if (!noted.ok() && !absl::IsAborted(noted)) return noted;
    for (const store::v1::JobRecord& record : records) {
      RETURN_IF_ERROR(parts_->streams.Purge(parts_->names.ends_stream(), ends_.SubjectOf(record.job())));
    }
    ids.clear();
    const std::vector<absl::StatusOr<bool>> removed = parts_->jobs.RemoveAll(revisions);
    for (size_t i = 0; i < revisions.size(); ++i) {
      if (!removed[i].ok()) return removed[i].status();
      forgotten += *removed[i] ? 1 : 0;
      if (!*removed[i]) ids.push_back(revisions[i].key);
    }
  }
  return forgotten;
}

// Deletes the noted artifacts of a batch without jobs, of so many jobs at a time.
absl::Status JetStreamWorkQueue::DeleteTombstoned(const std::string& batch_id, int64_t all, int64_t job_limit,
                                                  ArtifactStore& artifacts, Deleted& deleted) {
  std::vector<std::string> keys;
  for (int64_t end = all; end > 0; end -= kForgottenAtOnce) {
    keys.push_back(TombstoneKey(batch_id, std::max<int64_t>(0, end - kForgottenAtOnce)));
  }
  for (const std::string& key : keys) {
    ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> entry, IfFound(parts_->index.Get(key)));
    if (!entry.has_value()) continue;
    if (job_limit <= 0) return absl::OkStatus();
    job_limit -= kForgottenAtOnce;
    store::v1::ArtifactIds tombstones;
    if (!tombstones.ParseFromString(entry->value)) {
      return absl::DataLossError("the queue's note of artifacts is damaged");
    }
    const std::vector<std::string> ids(tombstones.ids().begin(), tombstones.ids().end());
    ASSIGN_OR_RETURN(const int64_t count, DeleteArtifacts(ids, batch_id, artifacts));
    deleted.artifact_count += count;
    RETURN_IF_ERROR(parts_->index.Remove({key, entry->revision}).status());
  }
  deleted.done = true;
  return absl::OkStatus();
}

// A batch that has no jobs and no artifacts any more.
absl::Status JetStreamWorkQueue::ForgetBatch(const store::v1::BatchRecord& record) {
  const std::string& id = record.batch().id();
  const std::string& owner = record.batch().owner();
  RETURN_IF_ERROR(parts_->requests.Put(NoteKey(owner, id), kBatchNote).status());
  RETURN_IF_ERROR(parts_->streams.Purge(parts_->names.ends_stream(), parts_->names.End(id, "*", "*", "*")));
  ASSIGN_OR_RETURN(const uint64_t last, parts_->streams.LastSequence(parts_->names.queue_stream()));
  const std::string subject = parts_->names.Batch(OwnerToken(owner), id);
  RETURN_IF_ERROR(consumers_.Remove(consumers_.ConsumerOf(subject), last));
  RETURN_IF_ERROR(RemoveRequest(RequestKey(owner, RequestKind::kBatch, record.request_id(), id), id));
  ASSIGN_OR_RETURN(const std::optional<RevisedBatch> now, IfFound(parts_->GetBatch(id)));
  if (now.has_value()) RETURN_IF_ERROR(parts_->batches.Remove({id, now->revision}).status());
  return RemoveNote(owner, id);
}

absl::StatusOr<Deleted> JetStreamWorkQueue::FinishDeletions(ArtifactStore& artifacts) {
  Deleted all{.done = true};
  ASSIGN_OR_RETURN(
      const auto notes,
      parts_->streams.Read(parts_->requests.stream(), parts_->requests.SubjectOf(std::string("*.") + kDeleting + ".*"),
                           1, kNotesAtOnce));
  for (const StoredMessage& note : notes) {
    const std::string key(parts_->requests.KeyOf(note.subject));
    const std::string id(TokenAt(key, 2));
    if (note.content == kJobNote) {
      ASSIGN_OR_RETURN(const std::optional<RevisedJob> job, IfFound(parts_->GetAnyJob(id)));
      const absl::StatusOr<Deleted> deleted = ForgetJob(id, job.has_value() ? job->value.job().owner() : "", artifacts);
      if (!deleted.ok() && !absl::IsFailedPrecondition(deleted.status())) return deleted;
      if (deleted.ok()) all.artifact_count += deleted->artifact_count;
      if (deleted.ok()) all.job_count += deleted->job_count;
    } else {
      ASSIGN_OR_RETURN(const std::optional<RevisedBatch> batch, IfFound(parts_->GetBatch(id)));
      RETURN_IF_ERROR(batch.has_value() ? ForgetBatch(batch->value) : absl::OkStatus());
    }
    // Also if nothing else is left that names its owner.
    RETURN_IF_ERROR(RemoveRequest(key, note.content));
  }
  return all;
}

}  // namespace flair::orchestrator
