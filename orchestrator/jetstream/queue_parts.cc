// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/queue_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

// How long a call goes on without an answer: longer than the servers of a queue take to choose a new leader.
constexpr absl::Duration kCallLimit = absl::Seconds(10);

template <typename Message>
absl::StatusOr<Revised<Message>> Parse(const absl::StatusOr<Bucket::Entry>& entry, const char* field,
                                       const std::string& id) {
  if (absl::IsNotFound(entry.status())) {
    return NotFound("{}: \"{}\" is not known here", field, id.substr(0, 80));
  }
  if (!entry.ok()) return entry.status();
  Revised<Message> revised;
  revised.revision = entry->revision;
  if (!revised.value.ParseFromString(entry->value)) {
    return DataLoss("{}: the queue's record of {} is damaged", field, id);
  }
  return revised;
}

template <typename Message>
absl::StatusOr<Revised<Message>> ChangeRecord(Bucket& bucket, const std::string& id,
                                              const std::function<absl::StatusOr<Revised<Message>>()>& get,
                                              const std::function<absl::StatusOr<bool>(Message&)>& change) {
  while (true) {
    ASSIGN_OR_RETURN(Revised<Message> record, get());
    ASSIGN_OR_RETURN(const bool changed, change(record.value));
    if (!changed) return record;
    const absl::StatusOr<uint64_t> revision = bucket.Update(id, runtime::CanonicalBytes(record.value), record.revision);
    // Another process was faster.
    if (absl::IsAborted(revision.status())) continue;
    RETURN_IF_ERROR(revision.status());
    record.revision = *revision;
    return record;
  }
}

absl::Duration LeaseOf(const config::v1::QueueConfig& config) {
  return absl::Seconds(config.has_lease_seconds() ? config.lease_seconds() : 30);
}

std::string WriteNotice(const Notice& notice) {
  return fmt::format("{} {} {}", static_cast<char>(notice.kind), notice.subject, notice.batch_id);
}

}  // namespace

QueueParts::QueueParts(std::unique_ptr<NatsConnection> opened, const config::v1::QueueConfig& config,
                       const runtime::Clock& the_clock)
    : connection(std::move(opened)),
      names(config),
      lease(LeaseOf(config)),
      clock(the_clock),
      streams(*connection, kCallLimit),
      jobs(streams, names.Bucket("jobs")),
      batches(streams, names.Bucket("batches")),
      requests(streams, names.Bucket("requests")),
      index(streams, names.Bucket("index")),
      statuses(streams, names.Bucket("status")) {}

absl::StatusOr<RevisedJob> QueueParts::ParseJob(const std::string& job_id,
                                                const absl::StatusOr<Bucket::Entry>& entry) const {
  absl::StatusOr<RevisedJob> job = Parse<store::v1::JobRecord>(entry, "job_id", job_id);
  if (job.ok() && job->value.deleting()) return Parse<store::v1::JobRecord>(absl::NotFoundError(""), "job_id", job_id);
  return job;
}

absl::StatusOr<RevisedJob> QueueParts::GetAnyJob(const std::string& job_id) {
  return Parse<store::v1::JobRecord>(IsToken(job_id) ? jobs.Get(job_id) : absl::NotFoundError(""), "job_id", job_id);
}

absl::StatusOr<RevisedJob> QueueParts::GetJob(const std::string& job_id) {
  return ParseJob(job_id, IsToken(job_id) ? jobs.Get(job_id) : absl::NotFoundError(""));
}

absl::StatusOr<RevisedBatch> QueueParts::GetBatch(const std::string& batch_id) {
  return Parse<store::v1::BatchRecord>(IsToken(batch_id) ? batches.Get(batch_id) : absl::NotFoundError(""), "batch_id",
                                       batch_id);
}

absl::StatusOr<RevisedJob> QueueParts::ChangeJob(const std::string& job_id,
                                                 const Change<store::v1::JobRecord>& change) {
  return ChangeRecord<store::v1::JobRecord>(
      jobs, job_id, [&] { return GetJob(job_id); }, change);
}

absl::StatusOr<RevisedBatch> QueueParts::ChangeBatch(const std::string& batch_id,
                                                     const Change<store::v1::BatchRecord>& change) {
  return ChangeRecord<store::v1::BatchRecord>(
      batches, batch_id, [&] { return GetBatch(batch_id); }, change);
}

std::string QueueParts::SubjectOf(const v1::Job& job) const {
  const std::string owner = OwnerToken(job.owner());
  return job.batch_id().empty() ? names.Single(owner) : names.Batch(owner, job.batch_id());
}

NatsRequest QueueParts::QueueMessage(const v1::Job& job, const std::string& message_id) const {
  return WithMessageId(SubjectOf(job), job.id(), message_id);
}

void QueueParts::Notify(Notice::Kind kind, const std::string& subject, const std::string& batch_id) {
  (void)connection->Publish({names.news_subject(), WriteNotice({kind, subject, batch_id}), {}});
}

void QueueParts::NotifyJob(const v1::Job& job) {
  // Watchers of the batch are only interested in ends.
  const bool open = job.state() == v1::JOB_STATE_QUEUED || job.state() == v1::JOB_STATE_RUNNING;
  Notify(Notice::Kind::kJob, job.id(), open ? "" : job.batch_id());
}

std::string QueueNames::Join(std::initializer_list<std::string_view> tokens) const {
  std::string subject = name_;
  for (std::string_view token : tokens) {
    subject += '.';
    subject += token;
  }
  return subject;
}

std::string OwnerToken(std::string_view owner) {
  if (owner.empty()) return "-";
  // What is a digest begins with another letter than what is a name, so that no name is another's digest.
  return IsToken(owner) && owner.size() <= 64 ? "o" + std::string(owner) : "h" + runtime::Sha256Hex(owner);
}

bool IsToken(std::string_view text) {
  return !text.empty() && text.size() <= 128 && std::ranges::all_of(text, [](char c) {
    return absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
  });
}

std::string_view TokenAt(std::string_view subject, int place) {
  for (; place > 0; --place) {
    const size_t dot = subject.find('.');
    if (dot == std::string_view::npos) return {};
    subject.remove_prefix(dot + 1);
  }
  return subject.substr(0, subject.find('.'));
}

std::string RequestKey(const std::string& owner, RequestKind kind, const std::string& request_id,
                       const std::string& id) {
  const char* token = kind == RequestKind::kJob ? ".single." : ".batch.";
  return OwnerToken(owner) + token + runtime::Sha256Hex(request_id.empty() ? id : request_id);
}

Notice ReadNotice(std::string_view text) {
  const std::vector<std::string> parts = absl::StrSplit(absl::string_view(text.data(), text.size()), ' ');
  if (parts.size() != 3 || parts[0].size() != 1) return {Notice::Kind{}, "", ""};
  return {static_cast<Notice::Kind>(parts[0][0]), parts[1], parts[2]};
}

}  // namespace flair::orchestrator
