// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of jobs and batches. Ids by age are in the bucket of requests, in the order in which they were made: it
// is read from its end.
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <functional>

#include "absl/strings/numbers.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Requests, and records, read at once.
constexpr uint64_t kRequestsAtOnce = 256;
constexpr size_t kRecordsAtOnce = 100;

// Messages in the queue of a batch above which its ends are not counted.
constexpr int64_t kCountedAtOnce = 300;

// Token of a request's key that says what was asked for.
constexpr int kKindToken = 1;

bool Fits(const v1::Job& job, const ListFilter& filter) {
  return (filter.state == v1::JOB_STATE_UNSPECIFIED || job.state() == filter.state) &&
         (!filter.owner.has_value() || job.owner() == *filter.owner);
}

bool IsBefore(const std::string& id, const ListFilter& filter) { return filter.before.empty() || id < filter.before; }

absl::Time ToTime(const google::protobuf::Timestamp& time) {
  return absl::FromUnixMicros(google::protobuf::util::TimeUtil::TimestampToMicroseconds(time));
}

}  // namespace

absl::StatusOr<v1::Job> JetStreamWorkQueue::GetJob(const std::string& job_id) {
  ASSIGN_OR_RETURN(RevisedJob job, parts_->GetJob(job_id));
  return std::move(*job.value.mutable_job());
}

absl::StatusOr<std::vector<v1::JobEvent>> JetStreamWorkQueue::EventsAfter(const std::string& job_id, int64_t sequence,
                                                                          int limit) {
  std::vector<v1::JobEvent> events;
  ASSIGN_OR_RETURN(const std::optional<RevisedJob> job, IfFound(parts_->GetJob(job_id)));
  if (!job.has_value()) return events;
  for (const v1::JobEvent& event : job->value.events()) {
    if (event.sequence() > sequence && static_cast<int>(events.size()) < limit) events.push_back(event);
  }
  return events;
}

// Of these, in this order, those that fit, until there are enough.
absl::StatusOr<std::vector<v1::Job>> JetStreamWorkQueue::GetJobs(std::span<const std::string> ids,
                                                                 const ListFilter& filter) {
  std::vector<v1::Job> jobs;
  while (!ids.empty() && static_cast<int>(jobs.size()) < filter.limit) {
    const std::span<const std::string> some = ids.first(std::min(ids.size(), kRecordsAtOnce));
    ids = ids.subspan(some.size());
    const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_->jobs.GetAll(some);
    for (size_t i = 0; i < some.size(); ++i) {
      ASSIGN_OR_RETURN(std::optional<RevisedJob> job, IfFound(parts_->ParseJob(some[i], entries[i])));
      // Asked for, and its making was interrupted.
      if (!job.has_value()) continue;
      if (Fits(job->value.job(), filter) && static_cast<int>(jobs.size()) < filter.limit) {
        jobs.push_back(std::move(*job->value.mutable_job()));
      }
    }
  }
  return jobs;
}

absl::StatusOr<std::vector<v1::Job>> JetStreamWorkQueue::ListOfBatch(const ListFilter& filter) {
  ASSIGN_OR_RETURN(const std::optional<RevisedBatch> batch, IfFound(parts_->GetBatch(filter.batch_id)));
  if (!batch.has_value()) return std::vector<v1::Job>();
  std::vector<std::string> ids;
  if (filter.state == v1::JOB_STATE_SUCCEEDED || filter.state == v1::JOB_STATE_FAILED ||
      filter.state == v1::JOB_STATE_CANCELLED) {
    ASSIGN_OR_RETURN(ids, ends_.JobsIn(filter.batch_id, filter.state));
  } else {
    for (int64_t i = batch->value.batch().job_count() - 1; i >= 0; --i) ids.push_back(BatchJobId(filter.batch_id, i));
  }
  std::erase_if(ids, [&](const std::string& id) { return !IsBefore(id, filter); });
  return GetJobs(ids, filter);
}

absl::StatusOr<std::vector<v1::Job>> JetStreamWorkQueue::ListJobs(const ListFilter& filter) {
  if (!filter.batch_id.empty()) return ListOfBatch(filter);
  std::vector<v1::Job> jobs;
  const auto add = [&](const std::string& kind, const std::string& id) -> absl::Status {
    ListFilter rest = filter;
    rest.limit = filter.limit - static_cast<int>(jobs.size());
    rest.batch_id = kind == "batch" ? id : "";
    ASSIGN_OR_RETURN(const std::vector<v1::Job> found,
                     kind == "batch" ? ListOfBatch(rest) : GetJobs(std::span(&id, IsBefore(id, filter) ? 1 : 0), rest));
    jobs.insert(jobs.end(), found.begin(), found.end());
    return absl::OkStatus();
  };
  RETURN_IF_ERROR(VisitRequests(
      filter, "*", [&] { return static_cast<int>(jobs.size()) < filter.limit; }, add));
  return jobs;
}

absl::StatusOr<std::vector<v1::Batch>> JetStreamWorkQueue::ListBatches(const ListFilter& filter) {
  std::vector<v1::Batch> batches;
  const auto add = [&](const std::string&, const std::string& id) -> absl::Status {
    if (!IsBefore(id, filter)) return absl::OkStatus();
    ASSIGN_OR_RETURN(std::optional<RevisedBatch> batch, IfFound(parts_->GetBatch(id)));
    if (!batch.has_value()) return absl::OkStatus();
    batches.push_back(std::move(*batch->value.mutable_batch()));
    return absl::OkStatus();
  };
  RETURN_IF_ERROR(VisitRequests(
      filter, "batch", [&] { return static_cast<int>(batches.size()) < filter.limit; }, add));
  return batches;
}

// Calls `visit` with kind and id of what was asked for, the newest first, while `more`.
absl::Status JetStreamWorkQueue::VisitRequests(
    const ListFilter& filter, const std::string& kind, const std::function<bool()>& more,
    const std::function<absl::Status(const std::string& kind, const std::string& id)>& visit) {
  const std::string& stream = parts_->requests.stream();
  const std::string owner = filter.owner.has_value() ? OwnerToken(*filter.owner) : "*";
  ASSIGN_OR_RETURN(const uint64_t last, parts_->streams.LastSequence(stream));
  uint64_t end = last + 1;
  while (end > 1 && more()) {
    const uint64_t first = end > kRequestsAtOnce ? end - kRequestsAtOnce : 1;
    ASSIGN_OR_RETURN(auto messages, parts_->streams.Read(stream, parts_->requests.SubjectOf(owner + "." + kind + ".*"),
                                                         first, static_cast<int>(end - first)));
    std::erase_if(messages, [end](const StoredMessage& message) { return message.sequence >= end; });
    // Made on several machines, some may be a little out of order.
    std::ranges::sort(messages, std::greater(), &StoredMessage::content);
    for (const StoredMessage& message : messages) {
      if (!more()) break;
      const std::string key(parts_->requests.KeyOf(message.subject));
      if (TokenAt(key, kKindToken) == kDeleting) continue;
      RETURN_IF_ERROR(visit(std::string(TokenAt(key, kKindToken)), message.content));
    }
    end = first;
  }
  return absl::OkStatus();
}

absl::StatusOr<v1::Batch> JetStreamWorkQueue::FindBatch(const std::string& batch_id) {
  ASSIGN_OR_RETURN(RevisedBatch record, parts_->GetBatch(batch_id));
  return std::move(*record.value.mutable_batch());
}

absl::StatusOr<v1::Batch> JetStreamWorkQueue::GetBatch(const std::string& batch_id) {
  ASSIGN_OR_RETURN(const RevisedBatch record, parts_->GetBatch(batch_id));
  v1::Batch batch = record.value.batch();
  RETURN_IF_ERROR(ends_.Count(batch));
  ASSIGN_OR_RETURN(const auto waiting, consumers_.Look(parts_->names.Batch(OwnerToken(batch.owner()), batch_id)));
  ASSIGN_OR_RETURN(const Streams::Depth depth, consumers_.DepthOf(waiting));
  batch.set_running_count(std::min(batch.open_count(), static_cast<int>(depth.delivered)));
  return batch;
}

absl::StatusOr<bool> JetStreamWorkQueue::BatchHasEnded(const std::string& batch_id) {
  ASSIGN_OR_RETURN(const RevisedBatch record, parts_->GetBatch(batch_id));
  const v1::Batch& batch = record.value.batch();
  if (batch.open()) return false;
  // Most of the time the few that are left are enough to know. The last ends are counted, since the messages of ended
  // jobs go a little later.
  ASSIGN_OR_RETURN(const auto messages, consumers_.Look(parts_->names.Batch(OwnerToken(batch.owner()), batch_id)));
  for (const auto& [subject, count] : messages) {
    if (count > kCountedAtOnce && batch.state() != v1::BATCH_STATE_CANCELLED) return false;
  }
  ASSIGN_OR_RETURN(const int64_t ended, ends_.CountAll(batch));
  return ended >= batch.job_count();
}

absl::StatusOr<std::vector<BatchEnd>> JetStreamWorkQueue::EndsAfter(const std::string& batch_id, int64_t sequence,
                                                                    int limit) {
  return ends_.After(batch_id, sequence, limit);
}

absl::StatusOr<int64_t> JetStreamWorkQueue::CountQueued() {
  ASSIGN_OR_RETURN(const auto messages, consumers_.Look(">"));
  ASSIGN_OR_RETURN(const Streams::Depth depth, consumers_.DepthOf(messages));
  return depth.waiting;
}

absl::StatusOr<int64_t> JetStreamWorkQueue::CountOpen(const std::string& owner) {
  ASSIGN_OR_RETURN(const auto messages, consumers_.Look(parts_->names.AllOf(OwnerToken(owner))));
  int64_t open = 0;
  for (const auto& [subject, count] : messages) {
    if (TokenAt(subject, 3) != "named") open += count;
  }
  return open;
}

absl::StatusOr<bool> JetStreamWorkQueue::OwnsArtifact(const std::string& owner, const std::string& artifact_id) {
  if (!IsToken(artifact_id)) return false;
  return users_.IsOwnedBy(OwnerToken(owner), artifact_id);
}

absl::StatusOr<std::optional<v1::ArtifactRef>> JetStreamWorkQueue::FindResult(const std::string& key) {
  ASSIGN_OR_RETURN(const std::optional<Bucket::Entry> entry, IfFound(parts_->index.Get("result." + key)));
  if (!entry.has_value()) return std::nullopt;
  v1::ArtifactRef artifact;
  if (!artifact.ParseFromString(entry->value)) return absl::DataLossError("the queue's index of results is damaged");
  return artifact;
}

// ---- What ended long ago: the bucket of requests is read from its beginning.

absl::StatusOr<EndedPage> JetStreamWorkQueue::EndedBefore(absl::Time time, const std::string& after, int limit) {
  uint64_t first = 0;
  if (!after.empty() && !absl::SimpleAtoi(after, &first)) return absl::InternalError("no page of a queue begins there");
  ASSIGN_OR_RETURN(
      const std::vector<StoredMessage> requests,
      parts_->streams.Read(parts_->requests.stream(), parts_->requests.SubjectOf("*.*.*"), first + 1, limit));
  EndedPage page;
  std::vector<std::string> alone;
  for (const StoredMessage& request : requests) {
    const std::string key(parts_->requests.KeyOf(request.subject));
    if (TokenAt(key, 1) == "single") alone.push_back(request.content);
    if (TokenAt(key, 1) != "batch") continue;
    ASSIGN_OR_RETURN(const bool ended, BatchEndedBefore(time, request.content));
    if (ended) page.batch_ids.push_back(request.content);
  }
  const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_->jobs.GetAll(alone);
  for (size_t i = 0; i < alone.size(); ++i) {
    ASSIGN_OR_RETURN(const std::optional<RevisedJob> job, IfFound(parts_->ParseJob(alone[i], entries[i])));
    if (!job.has_value()) continue;
    if (HasEnded(job->value) && ToTime(job->value.job().end_time()) < time) page.job_ids.push_back(alone[i]);
  }
  if (static_cast<int>(requests.size()) == limit) page.next = std::to_string(requests.back().sequence);
  return page;
}

absl::StatusOr<bool> JetStreamWorkQueue::BatchEndedBefore(absl::Time time, const std::string& batch_id) {
  ASSIGN_OR_RETURN(const std::optional<RevisedBatch> batch, IfFound(parts_->GetBatch(batch_id)));
  if (!batch.has_value()) return false;
  if (batch->value.has_deleted_job_count()) return true;
  if (batch->value.batch().open()) return false;
  absl::Time last_end = ToTime(batch->value.batch().create_time());
  ASSIGN_OR_RETURN(const std::string last_job, ends_.LastOf(batch_id));
  if (!last_job.empty()) {
    ASSIGN_OR_RETURN(const std::optional<RevisedJob> job, IfFound(parts_->GetJob(last_job)));
    // Retried, or just ended.
    if (job.has_value() && !HasEnded(job->value)) return false;
    if (job.has_value()) last_end = ToTime(job->value.job().end_time());
  }
  if (last_end >= time) return false;
  ASSIGN_OR_RETURN(const std::optional<bool> ended, IfFound(BatchHasEnded(batch_id)));
  // Another process may have deleted it just now.
  return ended.value_or(false);
}

}  // namespace flair::orchestrator
