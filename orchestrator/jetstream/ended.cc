// SPDX-License-Identifier: GPL-3.0-or-later
// What ended long ago: the bucket of requests is read from its beginning.
#include <google/protobuf/util/time_util.h>

#include <nlohmann/json.hpp>

#include "absl/strings/numbers.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "orchestrator/jetstream/job_record.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

absl::Time ToTime(const google::protobuf::Timestamp& time) {
  return absl::FromUnixMicros(google::protobuf::util::TimeUtil::TimestampToMicroseconds(time));
}

}  // namespace

absl::StatusOr<EndedPage> JetStreamWorkQueue::EndedBefore(absl::Time time, const std::string& after, int limit) {
  uint64_t first = 0;
  if (!after.empty() && !absl::SimpleAtoi(after, &first)) return absl::InternalError("no page of a queue begins there");
  const auto requests =
      parts_->reader.Read(parts_->requests.stream(),
                          {.filter = parts_->requests.SubjectOf("*.*.*"), .first_sequence = first + 1, .limit = limit});
  if (!requests.ok()) return requests.status();
  EndedPage page;
  std::vector<std::string> alone;
  for (const StreamReader::Message& request : *requests) {
    const std::string key(parts_->requests.KeyOf(request.subject));
    if (TokenAt(key, 1) == "single") alone.push_back(request.content);
    if (TokenAt(key, 1) != "batch") continue;
    ASSIGN_OR_RETURN(const bool ended, BatchEndedBefore(time, request.content));
    if (ended) page.batch_ids.push_back(request.content);
  }
  const std::vector<absl::StatusOr<Bucket::Entry>> entries = parts_->jobs.GetAll(alone);
  for (size_t i = 0; i < alone.size(); ++i) {
    const absl::StatusOr<RevisedJob> job = parts_->ParseJob(alone[i], entries[i]);
    if (absl::IsNotFound(job.status())) continue;
    if (!job.ok()) return job.status();
    if (HasEnded(job->value) && ToTime(job->value.job().end_time()) < time) page.job_ids.push_back(alone[i]);
  }
  if (static_cast<int>(requests->size()) == limit) page.next = std::to_string(requests->back().sequence);
  return page;
}

absl::StatusOr<bool> JetStreamWorkQueue::BatchEndedBefore(absl::Time time, const std::string& batch_id) {
  const absl::StatusOr<RevisedBatch> batch = parts_->GetBatch(batch_id);
  if (absl::IsNotFound(batch.status())) return false;
  if (!batch.ok()) return batch.status();
  if (batch->value.has_deleted_job_count()) return true;
  if (batch->value.batch().open()) return false;
  absl::Time last_end = ToTime(batch->value.batch().create_time());
  ASSIGN_OR_RETURN(const std::string last_job, ends_.LastOf(batch_id));
  if (!last_job.empty()) {
    const absl::StatusOr<RevisedJob> job = parts_->GetJob(last_job);
    if (!job.ok() && !absl::IsNotFound(job.status())) return job.status();
    // Retried, or just ended.
    if (job.ok() && !HasEnded(job->value)) return false;
    if (job.ok()) last_end = ToTime(job->value.job().end_time());
  }
  if (last_end >= time) return false;
  const absl::StatusOr<bool> ended = BatchHasEnded(batch_id);
  // Somebody else may have deleted it just now.
  return absl::IsNotFound(ended.status()) ? absl::StatusOr<bool>(false) : ended;
}

}  // namespace flair::orchestrator
