// SPDX-License-Identifier: GPL-3.0-or-later
// The RPCs that forget what has ended.
#include <fmt/format.h>

#include "orchestrator/service/orchestrator_handlers.h"

namespace flair::orchestrator {
namespace {

// Jobs of a batch that one call deletes: some seconds.
constexpr int kJobsPerCall = 1000;

// In the words of VisibleJob and VisibleBatch, whoever deleted it meanwhile.
absl::Status Gone(const absl::Status& status, const char* field, const char* what, const std::string& id) {
  if (!absl::IsNotFound(status)) return status;
  return absl::NotFoundError(fmt::format("{}: no {} \"{}\" in this store", field, what, id));
}

}  // namespace

absl::StatusOr<v1::DeleteJobResponse> OrchestratorHandlers::DeleteJob(const v1::DeleteJobRequest& request,
                                                                      const Caller& caller) {
  const absl::StatusOr<v1::Job> job = VisibleJob(request.job_id(), caller);
  if (!job.ok()) return job.status();
  const absl::StatusOr<Deleted> deleted = queue_.DeleteJob(job->id(), artifacts_);
  if (!deleted.ok()) return Gone(deleted.status(), "job_id", "job", job->id());
  v1::DeleteJobResponse response;
  response.set_deleted_artifact_count(deleted->artifact_count);
  return response;
}

absl::StatusOr<v1::DeleteBatchResponse> OrchestratorHandlers::DeleteBatch(const v1::DeleteBatchRequest& request,
                                                                          const Caller& caller) {
  const absl::StatusOr<v1::Batch> batch = VisibleBatch(request.batch_id(), caller);
  if (!batch.ok()) return batch.status();
  const absl::StatusOr<Deleted> deleted = queue_.DeleteBatch(batch->id(), kJobsPerCall, artifacts_);
  if (!deleted.ok()) return Gone(deleted.status(), "batch_id", "batch", batch->id());
  v1::DeleteBatchResponse response;
  response.set_deleted_job_count(deleted->job_count);
  response.set_deleted_artifact_count(deleted->artifact_count);
  response.set_done(deleted->done);
  return response;
}

}  // namespace flair::orchestrator
