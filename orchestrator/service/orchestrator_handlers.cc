// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/service/orchestrator_handlers.h"

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <vector>

#include "orchestrator/pipeline/replay.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/sha256.h"

namespace flair::orchestrator {
namespace {

std::string DigestOf(const v1::CreateBatchRequest& request) {
  std::string digests;
  for (const v1::JobSpec& spec : request.specs()) digests += runtime::Sha256Hex(runtime::CanonicalBytes(spec));
  return runtime::Sha256Hex(digests);
}

}  // namespace

v1::Job OrchestratorHandlers::NewJob(const v1::JobSpec& spec, const std::string& batch_id) {
  v1::Job job;
  job.set_id(ids_.Next());
  *job.mutable_spec() = spec;
  job.set_state(v1::JOB_STATE_QUEUED);
  job.set_batch_id(batch_id);
  *job.mutable_create_time() =
      google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(clock_.Now()));
  return job;
}

absl::Status OrchestratorHandlers::CheckQueue(int64_t job_count) {
  const absl::StatusOr<int64_t> queued = store_.jobs().CountQueued();
  if (!queued.ok()) return queued.status();
  if (*queued + job_count <= queued_job_limit_) return absl::OkStatus();
  return absl::ResourceExhaustedError(fmt::format(
      "{} jobs wait, {} more would be over the limit of {}; try again later", *queued, job_count, queued_job_limit_));
}

absl::StatusOr<v1::CreateJobResponse> OrchestratorHandlers::CreateJob(const v1::CreateJobRequest& request, Call&) {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  v1::CreateJobResponse response;
  {
    auto transaction = Transaction::Begin(store_.database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const absl::StatusOr<std::string> known = store_.jobs().FindByRequest(request.request_id());
    if (!known.ok()) return known.status();
    if (known->empty()) {
      absl::Status status = CheckReplay(request.spec(), store_);
      if (status.ok()) status = CheckQueue(1);
      if (!status.ok()) return status;
      *response.mutable_job() = NewJob(request.spec(), "");
      status = store_.jobs().Insert(response.job(), request.request_id());
      if (status.ok()) status = transaction->Commit();
      if (!status.ok()) return status;
    } else {
      absl::StatusOr<v1::Job> job = store_.jobs().Get(*known);
      if (!job.ok()) return job.status();
      if (runtime::CanonicalBytes(job->spec()) != runtime::CanonicalBytes(request.spec())) {
        return absl::AlreadyExistsError(fmt::format("request_id: \"{}\" made job {} with another spec; use a new id",
                                                    request.request_id(), job->id()));
      }
      *response.mutable_job() = *std::move(job);
    }
  }
  runner_.Request({response.job().id()});
  return response;
}

absl::StatusOr<v1::GetJobResponse> OrchestratorHandlers::GetJob(const v1::GetJobRequest& request, Call&) {
  absl::StatusOr<v1::Job> job = store_.jobs().Get(request.job_id());
  if (!job.ok()) return job.status();
  v1::GetJobResponse response;
  *response.mutable_job() = *std::move(job);
  return response;
}

absl::StatusOr<v1::ListJobsResponse> OrchestratorHandlers::ListJobs(const v1::ListJobsRequest& request, Call&) {
  if (request.page_size() < 0 || request.page_size() > 1000) {
    return absl::InvalidArgumentError(fmt::format("page_size: {} is out of range [0, 1000]", request.page_size()));
  }
  const int limit = request.page_size() == 0 ? 50 : request.page_size();
  // One more than asked for tells whether there is another page.
  absl::StatusOr<std::vector<v1::Job>> jobs = store_.jobs().List(limit + 1, request.page_token(), request.batch_id());
  if (!jobs.ok()) return jobs.status();
  v1::ListJobsResponse response;
  if (static_cast<int>(jobs->size()) > limit) {
    jobs->resize(static_cast<size_t>(limit));
    response.set_next_page_token(jobs->back().id());
  }
  response.mutable_jobs()->Assign(jobs->begin(), jobs->end());
  return response;
}

absl::StatusOr<v1::CancelJobResponse> OrchestratorHandlers::CancelJob(const v1::CancelJobRequest& request, Call&) {
  if (absl::Status status = runner_.Cancel(request.job_id()); !status.ok()) return status;
  absl::StatusOr<v1::Job> job = store_.jobs().Get(request.job_id());
  if (!job.ok()) return job.status();
  v1::CancelJobResponse response;
  *response.mutable_job() = *std::move(job);
  return response;
}

absl::StatusOr<v1::CreateBatchResponse> OrchestratorHandlers::CreateBatch(const v1::CreateBatchRequest& request,
                                                                          Call&) {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  const std::string digest = DigestOf(request);
  std::string batch_id;
  std::vector<std::string> job_ids;
  {
    auto transaction = Transaction::Begin(store_.database(), Transaction::Durability::kPowerLoss);
    if (!transaction.ok()) return transaction.status();
    const auto known = store_.batches().FindByRequest(request.request_id());
    if (!known.ok()) return known.status();
    if (known->has_value() && (*known)->specs_digest != digest) {
      return absl::AlreadyExistsError(fmt::format("request_id: \"{}\" made batch {} of other specs; use a new id",
                                                  request.request_id(), (*known)->id));
    }
    if (known->has_value()) {
      batch_id = (*known)->id;
    } else {
      absl::Status status = CheckQueue(request.specs_size());
      for (int i = 0; status.ok() && i < request.specs_size(); ++i) status = CheckReplay(request.specs(i), store_);
      if (!status.ok()) return status;
      batch_id = ids_.Next();
      status = store_.batches().Insert(batch_id, request.request_id(), digest);
      for (int i = 0; status.ok() && i < request.specs_size(); ++i) {
        const v1::Job job = NewJob(request.specs(i), batch_id);
        job_ids.push_back(job.id());
        status = store_.jobs().Insert(job, "");
      }
      if (status.ok()) status = transaction->Commit();
      if (!status.ok()) return status;
    }
  }
  runner_.Request(job_ids);
  absl::StatusOr<v1::Batch> batch = store_.batches().Get(batch_id);
  if (!batch.ok()) return batch.status();
  v1::CreateBatchResponse response;
  *response.mutable_batch() = *std::move(batch);
  return response;
}

absl::StatusOr<v1::GetBatchResponse> OrchestratorHandlers::GetBatch(const v1::GetBatchRequest& request, Call&) {
  absl::StatusOr<v1::Batch> batch = store_.batches().Get(request.batch_id());
  if (!batch.ok()) return batch.status();
  v1::GetBatchResponse response;
  *response.mutable_batch() = *std::move(batch);
  return response;
}

absl::StatusOr<v1::GetArtifactResponse> OrchestratorHandlers::GetArtifact(const v1::GetArtifactRequest& request,
                                                                          Call&) {
  absl::StatusOr<v1::Artifact> artifact = store_.files().Get(request.artifact_id());
  if (!artifact.ok()) return artifact.status();
  v1::GetArtifactResponse response;
  *response.mutable_artifact() = *std::move(artifact);
  return response;
}

}  // namespace flair::orchestrator
