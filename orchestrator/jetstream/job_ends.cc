// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/job_ends.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>

#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

// Places of the state, then the kind, and of the job's id in the subject of its end.
constexpr int kStateToken = 3;
constexpr int kJobToken = 5;
// Jobs of a batch whose ends are listed: an answer of some hundred KiB.
constexpr int kListed = 4000;
// Ends read at once when all of a kind are wanted.
constexpr int kReadAtOnce = 10000;

std::string Number(int value) { return std::to_string(value); }

}  // namespace

std::string JobEnds::SubjectOf(const v1::Job& job) const {
  return parts_.names.End(job.batch_id(), Number(job.state()), Number(job.failure_kind()), job.id());
}

absl::Status JobEnds::Publish(std::span<const v1::Job> jobs) {
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

absl::Status JobEnds::Remove(const v1::Job& job) {
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

absl::StatusOr<std::string> JobEnds::LastOf(const std::string& batch_id) {
  const absl::StatusOr<json> last = parts_.api.Call("STREAM.MSG.GET." + parts_.names.ends_stream(),
                                                    json{{"last_by_subj", parts_.names.End(batch_id, "*", "*", "*")}});
  if (absl::IsNotFound(last.status())) return "";
  if (!last.ok()) return last.status();
  return std::string(TokenAt(last->value("message", json::object()).value("subject", ""), kJobToken));
}

absl::StatusOr<int64_t> JobEnds::CountAll(const v1::Batch& batch) {
  const std::string all = parts_.names.End(batch.id(), "*", "*", "*");
  if (batch.job_count() <= kListed) {
    ASSIGN_OR_RETURN(const auto subjects, parts_.reader.Subjects(parts_.names.ends_stream(), all));
    return static_cast<int64_t>(subjects.size());
  }
  ASSIGN_OR_RETURN(const auto counts, parts_.reader.Count(parts_.names.ends_stream(), std::span(&all, 1)));
  return counts.front();
}

// Jobs by how they ended. Of few, the subjects are listed; of many, the servers count.
absl::StatusOr<std::map<JobEnds::Outcome, int64_t>> JobEnds::CountOutcomes(const v1::Batch& batch) {
  const std::string stream = parts_.names.ends_stream();
  std::map<Outcome, int64_t> counts;
  if (batch.job_count() <= kListed) {
    ASSIGN_OR_RETURN(const auto subjects, parts_.reader.Subjects(stream, parts_.names.End(batch.id(), "*", "*", "*")));
    for (const auto& [subject, count] : subjects) {
      ++counts[{std::string(TokenAt(subject, kStateToken)), std::string(TokenAt(subject, kStateToken + 1))}];
    }
    return counts;
  }
  std::vector<Outcome> outcomes = {{Number(v1::JOB_STATE_SUCCEEDED), "*"},
                                   {Number(v1::JOB_STATE_CANCELLED), "*"},
                                   {Number(v1::JOB_STATE_FAILED), "*"}};
  // Most of the time none has failed.
  for (int round = 0; round < 2 && !outcomes.empty(); ++round) {
    std::vector<std::string> filters;
    for (const Outcome& outcome : outcomes) {
      filters.push_back(parts_.names.End(batch.id(), outcome.first, outcome.second, "*"));
    }
    ASSIGN_OR_RETURN(const auto found, parts_.reader.Count(stream, filters));
    for (size_t i = 0; i < outcomes.size(); ++i) counts[outcomes[i]] = (found)[i];
    outcomes.clear();
    const auto failed = counts.extract(Outcome(Number(v1::JOB_STATE_FAILED), "*"));
    if (failed.empty() || failed.mapped() == 0) continue;
    for (int kind = v1::FailureKind_MIN; kind <= v1::FailureKind_MAX; ++kind) {
      outcomes.emplace_back(Number(v1::JOB_STATE_FAILED), Number(kind));
    }
  }
  return counts;
}

absl::Status JobEnds::Count(v1::Batch& batch) {
  ASSIGN_OR_RETURN(const auto counts, CountOutcomes(batch));
  for (const auto& [outcome, count_64] : counts) {
    const auto count = static_cast<int>(count_64);
    if (count == 0) continue;
    if (outcome.first == Number(v1::JOB_STATE_SUCCEEDED)) batch.set_succeeded_count(batch.succeeded_count() + count);
    if (outcome.first == Number(v1::JOB_STATE_CANCELLED)) batch.set_cancelled_count(batch.cancelled_count() + count);
    if (outcome.first != Number(v1::JOB_STATE_FAILED)) continue;
    batch.set_failed_count(batch.failed_count() + count);
    v1::FailureCount& failures = *batch.add_failures();
    failures.set_kind(static_cast<v1::FailureKind>(std::atoi(outcome.second.c_str())));
    failures.set_job_count(count);
  }
  std::ranges::stable_sort(*batch.mutable_failures(), std::greater(), &v1::FailureCount::job_count);
  const int ended = batch.succeeded_count() + batch.failed_count() + batch.cancelled_count();
  // Of an open batch, jobs may have ended that it does not count yet.
  batch.set_open_count(std::max(0, batch.job_count() - ended));
  return absl::OkStatus();
}

absl::StatusOr<std::vector<BatchEnd>> JobEnds::Read(const std::string& filter, int64_t sequence, int limit) {
  ASSIGN_OR_RETURN(const auto messages,
                   parts_.reader.Read(parts_.names.ends_stream(),
                                      {.filter = filter,
                                       .first_sequence = static_cast<uint64_t>(std::max<int64_t>(0, sequence)) + 1,
                                       .limit = limit,
                                       .with_content = false}));
  std::vector<BatchEnd> ends;
  for (const StreamReader::Message& message : messages) {
    ends.push_back({static_cast<int64_t>(message.sequence), std::string(TokenAt(message.subject, kJobToken))});
  }
  return ends;
}

absl::StatusOr<std::vector<BatchEnd>> JobEnds::After(const std::string& batch_id, int64_t sequence, int limit) {
  if (!IsToken(batch_id)) return std::vector<BatchEnd>();
  return Read(parts_.names.End(batch_id, "*", "*", "*"), sequence, limit);
}

absl::StatusOr<std::vector<std::string>> JobEnds::JobsIn(const std::string& batch_id, v1::JobState state) {
  const std::string filter = parts_.names.End(batch_id, Number(state), "*", "*");
  std::vector<std::string> ids;
  for (int64_t sequence = 0;;) {
    ASSIGN_OR_RETURN(const std::vector<BatchEnd> ends, Read(filter, sequence, kReadAtOnce));
    for (const BatchEnd& end : ends) ids.push_back(end.job_id);
    if (static_cast<int>(ends.size()) < kReadAtOnce) break;
    sequence = ends.back().sequence;
  }
  std::ranges::sort(ids, std::greater());
  return ids;
}

}  // namespace flair::orchestrator
