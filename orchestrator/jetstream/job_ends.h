// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/queue_parts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// The ends of batches' jobs, in the order in which they came. The record of a job says that it has ended; what is here
// follows from it, and may be published again. How a job ended is in its subject, so that servers count by it. Errors
// as Streams. Thread-safe.
class JobEnds {
 public:
  explicit JobEnds(QueueParts& parts) : parts_(parts) {}

  // Records ended jobs; single jobs and those already recorded are skipped.
  absl::Status Publish(std::span<const v1::Job> jobs) {
    std::vector<NatsRequest> messages;
    for (const v1::Job& job : jobs) {
      if (job.batch_id().empty()) continue;
      // Only where there is none yet, so that watchers are not notified twice.
      messages.push_back(WithExpected(SubjectOf(job), "", 0));
    }
    absl::Status failed;
    for (const absl::StatusOr<uint64_t>& ack : parts_.streams.PublishAll(messages)) {
      if (!absl::IsAborted(ack.status())) failed.Update(ack.status());
    }
    return failed;
  }

  // Takes back the end of a failed job.
  absl::Status Remove(const v1::Job& job) {
    if (job.batch_id().empty()) return absl::OkStatus();
    const std::string stream = parts_.names.ends_stream();
    ASSIGN_OR_RETURN(const std::optional<StoredMessage> found, IfFound(parts_.streams.Last(stream, SubjectOf(job))));
    if (!found.has_value()) return absl::OkStatus();
    return parts_.streams.Remove(stream, std::span(&found->sequence, 1)).front().status();
  }

  // Fills in the counts of a batch but running_count.
  absl::Status Count(v1::Batch& batch) {
    ASSIGN_OR_RETURN(const auto subjects,
                     parts_.streams.Subjects(parts_.names.ends_stream(), parts_.names.End(batch.id(), "*", "*", "*")));
    EndCounts ends;
    for (const auto& [subject, count] : subjects) {
      ++ends[{static_cast<v1::JobState>(NumberAt(subject, kStateToken)),
              static_cast<v1::FailureKind>(NumberAt(subject, kStateToken + 1))}];
    }
    SetCounts(ends, batch);
    return absl::OkStatus();
  }

  absl::StatusOr<int64_t> CountAll(const v1::Batch& batch) {
    const std::string all = parts_.names.End(batch.id(), "*", "*", "*");
    if (batch.job_count() > kListed) return parts_.streams.Count(parts_.names.ends_stream(), all);
    ASSIGN_OR_RETURN(const auto subjects, parts_.streams.Subjects(parts_.names.ends_stream(), all));
    return static_cast<int64_t>(subjects.size());
  }

  // The job of the batch that ended last; empty when none has.
  absl::StatusOr<std::string> LastOf(const std::string& batch_id) {
    ASSIGN_OR_RETURN(
        const std::optional<StoredMessage> last,
        IfFound(parts_.streams.Last(parts_.names.ends_stream(), parts_.names.End(batch_id, "*", "*", "*"))));
    if (!last.has_value()) return "";
    return std::string(TokenAt(last->subject, kJobToken));
  }

  // Under which the end of the job is.
  std::string SubjectOf(const v1::Job& job) const {
    return parts_.names.End(job.batch_id(), Number(job.state()), Number(job.failure_kind()), job.id());
  }

  absl::StatusOr<std::vector<BatchEnd>> After(const std::string& batch_id, int64_t sequence, int limit) {
    std::vector<BatchEnd> ends;
    if (!IsToken(batch_id)) return ends;
    ASSIGN_OR_RETURN(const auto messages,
                     parts_.streams.Read(parts_.names.ends_stream(), parts_.names.End(batch_id, "*", "*", "*"),
                                         static_cast<uint64_t>(std::max<int64_t>(0, sequence)) + 1, limit));
    for (const StoredMessage& message : messages) {
      ends.push_back({static_cast<int64_t>(message.sequence), std::string(TokenAt(message.subject, kJobToken))});
    }
    return ends;
  }

  // The jobs that ended so, by id, those with larger ids first.
  absl::StatusOr<std::vector<std::string>> JobsIn(const std::string& batch_id, v1::JobState state) {
    ASSIGN_OR_RETURN(const auto subjects, parts_.streams.Subjects(parts_.names.ends_stream(),
                                                                  parts_.names.End(batch_id, Number(state), "*", "*")));
    std::vector<std::string> ids;
    for (const auto& [subject, count] : subjects) ids.emplace_back(TokenAt(subject, kJobToken));
    std::ranges::sort(ids, std::greater());
    return ids;
  }

 private:
  // Places of the state, then the kind, and of the job's id in the subject of its end.
  static constexpr int kStateToken = 3;
  static constexpr int kJobToken = 5;
  // Jobs of a batch whose ends are listed, not counted by the servers: an answer of some hundred KiB.
  static constexpr int kListed = 4000;

  static std::string Number(int value) { return std::to_string(value); }
  static int NumberAt(const std::string& subject, int place) {
    return std::atoi(std::string(TokenAt(subject, place)).c_str());
  }

  QueueParts& parts_;
};

}  // namespace flair::orchestrator
