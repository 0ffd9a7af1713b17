// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/ends.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

namespace flair::orchestrator {
namespace {

using nlohmann::json;

// Place of the job's id in the subject of its end.
constexpr int kJobToken = 5;
// Ends read at once when all of a kind are wanted.
constexpr int kReadAtOnce = 10000;

std::string Number(int value) { return std::to_string(value); }

}  // namespace

std::string Ends::SubjectOf(const v1::Job& job) const {
  return parts_.names.End(job.batch_id(), Number(job.state()), Number(job.failure_kind()), job.id());
}

absl::Status Ends::Publish(std::span<const v1::Job> jobs) {
  std::vector<NatsRequest> messages;
  for (const v1::Job& job : jobs) {
    if (job.batch_id().empty()) continue;
    // Only where there is none yet, so that watchers are not told twice.
    messages.push_back({SubjectOf(job), "", {{"Nats-Expected-Last-Subject-Sequence", "0"}}});
  }
  if (messages.size() == 1) {
    const absl::Status status = parts_.api.Publish(messages.front()).status();
    return absl::IsAborted(status) ? absl::OkStatus() : status;
  }
  absl::Status failed;
  for (const absl::StatusOr<StoredAck>& ack : parts_.api.PublishAll(messages)) {
    if (!absl::IsAborted(ack.status())) failed.Update(ack.status());
  }
  return failed;
}

absl::Status Ends::Remove(const v1::Job& job) {
  if (job.batch_id().empty()) return absl::OkStatus();
  const std::string stream = parts_.names.ends_stream();
  const absl::StatusOr<json> found =
      parts_.api.Call("STREAM.MSG.GET." + stream, json{{"last_by_subj", SubjectOf(job)}});
  if (absl::IsNotFound(found.status())) return absl::OkStatus();
  if (!found.ok()) return found.status();
  const uint64_t sequence = found->value("message", json::object()).value("seq", uint64_t{0});
  const absl::Status removed =
      parts_.api.Call("STREAM.MSG.DELETE." + stream, json{{"seq", sequence}, {"no_erase", true}}).status();
  return absl::IsNotFound(removed) ? absl::OkStatus() : removed;
}

absl::StatusOr<int64_t> Ends::CountAll(const std::string& batch_id) {
  const std::string all = parts_.names.End(batch_id, "*", "*", "*");
  const auto counts = parts_.reader.Count(parts_.names.ends_stream(), std::span(&all, 1));
  if (!counts.ok()) return counts.status();
  return counts->front();
}

absl::Status Ends::Count(v1::Batch& batch) {
  const std::string stream = parts_.names.ends_stream();
  std::vector<std::string> filters;
  for (v1::JobState state : {v1::JOB_STATE_SUCCEEDED, v1::JOB_STATE_FAILED, v1::JOB_STATE_CANCELLED}) {
    filters.push_back(parts_.names.End(batch.id(), Number(state), "*", "*"));
  }
  const auto counts = parts_.reader.Count(stream, filters);
  if (!counts.ok()) return counts.status();
  batch.set_succeeded_count(static_cast<int>((*counts)[0]));
  batch.set_failed_count(static_cast<int>((*counts)[1]));
  batch.set_cancelled_count(static_cast<int>((*counts)[2]));
  const int ended = batch.succeeded_count() + batch.failed_count() + batch.cancelled_count();
  // Of an open batch, jobs may have ended that it does not count yet.
  batch.set_open_count(std::max(0, batch.job_count() - ended));
  if (batch.failed_count() == 0) return absl::OkStatus();
  filters.clear();
  for (int kind = v1::FailureKind_MIN; kind <= v1::FailureKind_MAX; ++kind) {
    filters.push_back(parts_.names.End(batch.id(), Number(v1::JOB_STATE_FAILED), Number(kind), "*"));
  }
  const auto kinds = parts_.reader.Count(stream, filters);
  if (!kinds.ok()) return kinds.status();
  for (size_t i = 0; i < kinds->size(); ++i) {
    if ((*kinds)[i] == 0) continue;
    v1::FailureCount& failures = *batch.add_failures();
    failures.set_kind(static_cast<v1::FailureKind>(v1::FailureKind_MIN + static_cast<int>(i)));
    failures.set_job_count(static_cast<int>((*kinds)[i]));
  }
  std::ranges::stable_sort(*batch.mutable_failures(), std::greater(), &v1::FailureCount::job_count);
  return absl::OkStatus();
}

absl::StatusOr<std::vector<BatchEnd>> Ends::Read(const std::string& filter, int64_t sequence, int limit) {
  const auto messages = parts_.reader.Read(parts_.names.ends_stream(),
                                           {.filter = filter,
                                            .first_sequence = static_cast<uint64_t>(std::max<int64_t>(0, sequence)) + 1,
                                            .limit = limit,
                                            .with_content = false});
  if (!messages.ok()) return messages.status();
  std::vector<BatchEnd> ends;
  for (const StreamReader::Message& message : *messages) {
    ends.push_back({static_cast<int64_t>(message.sequence), std::string(TokenAt(message.subject, kJobToken))});
  }
  return ends;
}

absl::StatusOr<std::vector<BatchEnd>> Ends::After(const std::string& batch_id, int64_t sequence, int limit) {
  if (!IsToken(batch_id)) return std::vector<BatchEnd>();
  return Read(parts_.names.End(batch_id, "*", "*", "*"), sequence, limit);
}

absl::StatusOr<std::vector<std::string>> Ends::JobsIn(const std::string& batch_id, v1::JobState state) {
  const std::string filter = parts_.names.End(batch_id, Number(state), "*", "*");
  std::vector<std::string> ids;
  for (int64_t sequence = 0;;) {
    const absl::StatusOr<std::vector<BatchEnd>> ends = Read(filter, sequence, kReadAtOnce);
    if (!ends.ok()) return ends.status();
    for (const BatchEnd& end : *ends) ids.push_back(end.job_id);
    if (static_cast<int>(ends->size()) < kReadAtOnce) break;
    sequence = ends->back().sequence;
  }
  std::ranges::sort(ids, std::greater());
  return ids;
}

}  // namespace flair::orchestrator
