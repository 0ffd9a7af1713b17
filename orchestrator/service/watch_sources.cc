// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/watches.h"

namespace flair::orchestrator {
namespace {
// Read from the queue at once.
constexpr int kReadLimit = 64;
}  // namespace

WatchSource<v1::WatchJobResponse> JobSource(WorkQueue& queue, const std::string& job_id,
                                            std::function<absl::Status()> admit) {
  WatchSource<v1::WatchJobResponse> source;
  source.rpc = "WatchJob";
  source.id = job_id;
  source.ids.job_id = job_id;
  source.admit = std::move(admit);
  source.next = [&queue, job_id](int64_t after) -> absl::StatusOr<std::vector<v1::WatchJobResponse>> {
    auto events = queue.EventsAfter(job_id, after, kReadLimit);
    if (!events.ok()) return events.status();
    std::vector<v1::WatchJobResponse> responses(events->size());
    for (size_t i = 0; i < responses.size(); ++i) *responses[i].mutable_event() = std::move((*events)[i]);
    return responses;
  };
  source.has_ended = [&queue, job_id](int64_t after) -> absl::StatusOr<bool> {
    // An end that was retried is followed by other events.
    if (after == 0) return false;
    const auto last = queue.EventsAfter(job_id, after - 1, 2);
    if (!last.ok()) return last.status();
    return last->size() == 1 && last->front().kind() == v1::JOB_EVENT_KIND_ENDED;
  };
  source.sequence_of = [](const v1::WatchJobResponse& response) { return response.event().sequence(); };
  return source;
}

WatchSource<v1::WatchBatchResponse> BatchSource(WorkQueue& queue, const std::string& batch_id,
                                                std::function<absl::Status()> admit) {
  WatchSource<v1::WatchBatchResponse> source;
  source.rpc = "WatchBatch";
  source.id = batch_id;
  source.ids.batch_id = batch_id;
  source.admit = std::move(admit);
  source.next = [&queue, batch_id](int64_t after) -> absl::StatusOr<std::vector<v1::WatchBatchResponse>> {
    const auto ends = queue.EndsAfter(batch_id, after, kReadLimit);
    if (!ends.ok()) return ends.status();
    std::vector<v1::WatchBatchResponse> responses;
    for (const BatchEnd& end : *ends) {
      absl::StatusOr<v1::Job> job = queue.GetJob(end.job_id);
      if (!job.ok()) return job.status();
      responses.emplace_back().set_sequence(end.sequence);
      *responses.back().mutable_job() = *std::move(job);
    }
    return responses;
  };
  source.has_ended = [&queue, batch_id](int64_t after) -> absl::StatusOr<bool> {
    const absl::StatusOr<bool> ended = queue.BatchHasEnded(batch_id);
    if (!ended.ok() || !*ended) return ended;
    // One may have ended since the last look.
    const auto ends = queue.EndsAfter(batch_id, after, 1);
    if (!ends.ok()) return ends.status();
    return ends->empty();
  };
  source.sequence_of = [](const v1::WatchBatchResponse& response) { return response.sequence(); };
  return source;
}

}  // namespace flair::orchestrator
