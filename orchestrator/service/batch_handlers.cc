// SPDX-License-Identifier: GPL-3.0-or-later
// The RPCs of batches, and those that delete what has ended.

#include <fmt/format.h>
#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <vector>

#include "orchestrator/service/orchestrator_handlers.h"
#include "room/validation/validate.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// Jobs given to the queue at once, or looked at for a retry.
constexpr int kPage = 1000;

// Tells a repeat of a request from another one.
std::string DigestOf(const v1::CreateBatchRequest& request) {
  std::string digests = request.open() ? "open" : "";
  for (const v1::JobSpec& spec : request.specs()) digests += runtime::Sha256Hex(runtime::CanonicalBytes(spec));
  return runtime::Sha256Hex(digests);
}

bool IsAskedFor(const v1::Job& job, const v1::RetryBatchRequest& request) {
  return job.batch_id() == request.batch_id() && job.state() == v1::JOB_STATE_FAILED &&
         (request.kinds().empty() || std::ranges::find(request.kinds(), job.failure_kind()) != request.kinds().end());
}

template <typename Response>
absl::StatusOr<Response> Answer(absl::StatusOr<v1::Batch> batch) {
  Response response;
  ASSIGN_OR_RETURN(*response.mutable_batch(), std::move(batch));
  return response;
}

// Jobs of a batch that one call deletes: some seconds.
constexpr int kJobsPerCall = 1000;

// In the words of VisibleJob and VisibleBatch, whoever deleted it meanwhile.
absl::Status Gone(const absl::Status& status, const char* field, const char* what, const std::string& id) {
  if (!absl::IsNotFound(status)) return status;
  return NotFound("{}: no {} \"{}\" in this store", field, what, id);
}

}  // namespace

absl::StatusOr<v1::Batch> OrchestratorHandlers::VisibleBatch(const std::string& id, const Caller& caller) {
  absl::StatusOr<v1::Batch> batch = queue_.FindBatch(id);
  const bool hidden = batch.ok() ? !caller.MaySee(batch->owner()) : absl::IsNotFound(batch.status());
  if (!hidden) return batch;
  return NotFound("batch_id: no batch \"{}\" in this store", id.substr(0, 80));
}

absl::StatusOr<v1::Batch> OrchestratorHandlers::Add(const v1::Batch& batch, int64_t first_index,
                                                    const google::protobuf::RepeatedPtrField<v1::JobSpec>& specs,
                                                    bool last, const Caller& caller, JobAdmission::Entry& entry) {
  for (const v1::JobSpec& spec : specs) RETURN_IF_ERROR(CheckSpec(spec, caller));
  // Those that are there already need no room.
  const int64_t added = std::max<int64_t>(0, first_index + specs.size() - batch.job_count());
  RETURN_IF_ERROR(entry.Grant(added));
  absl::StatusOr<v1::Batch> grown = batch;
  int at = 0;
  do {
    std::vector<v1::Job> page;
    for (; at < specs.size() && page.size() < kPage; ++at) {
      v1::Job& job = page.emplace_back(NewJob(specs[at]));
      job.set_id(BatchJobId(batch.id(), first_index + at));
      job.set_batch_id(batch.id());
      job.set_batch_index(first_index + at);
      job.set_owner(batch.owner());
    }
    grown = queue_.AddJobs(batch.id(), page, last && at == specs.size());
  } while (grown.ok() && at < specs.size());
  if (grown.ok()) runner_.Request({}, batch.id());
  return grown;
}

absl::StatusOr<v1::CreateBatchResponse> OrchestratorHandlers::CreateBatch(const v1::CreateBatchRequest& request,
                                                                          const Caller& caller) {
  RETURN_IF_ERROR(Validate(request));
  store::v1::BatchRecord record;
  record.set_request_id(caller.RequestKey(request.request_id()));
  record.set_specs_digest(DigestOf(request));
  v1::Batch& batch = *record.mutable_batch();
  batch.set_id(ids_.Next());
  // Until its jobs are there; a repeat of the request adds those that a crash kept out.
  batch.set_open(true);
  batch.set_state(v1::BATCH_STATE_ACTIVE);
  batch.set_label(request.label());
  batch.set_owner(caller.name);
  *batch.mutable_create_time() =
      google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(clock_.Now()));
  JobAdmission::Entry entry(admission_, caller);
  RETURN_IF_ERROR(UnlessRepeated(entry.Grant(request.specs_size()), RequestKind::kBatch, request.request_id(), caller));
  for (const v1::JobSpec& spec : request.specs()) RETURN_IF_ERROR(CheckSpec(spec, caller));
  ASSIGN_OR_RETURN(const store::v1::BatchRecord made, queue_.CreateBatch(record));
  if (made.specs_digest() != record.specs_digest()) {
    return absl::AlreadyExistsError(fmt::format("request_id: \"{}\" made batch {} of other specs; use a new id",
                                                request.request_id(), made.batch().id()));
  }
  if (made.batch().open()) {
    RETURN_IF_ERROR(Add(made.batch(), 0, request.specs(), !request.open(), caller, entry).status());
  }
  runner_.Request({}, made.batch().id());
  return Answer<v1::CreateBatchResponse>(queue_.GetBatch(made.batch().id()));
}

absl::StatusOr<v1::AddToBatchResponse> OrchestratorHandlers::AddToBatch(const v1::AddToBatchRequest& request,
                                                                        const Caller& caller) {
  RETURN_IF_ERROR(Validate(request));
  // Before the batch is read: what a call before this one adds needs no room.
  JobAdmission::Entry entry(admission_, caller);
  ASSIGN_OR_RETURN(const v1::Batch batch, VisibleBatch(request.batch_id(), caller));
  return Answer<v1::AddToBatchResponse>(
      Add(batch, request.first_index(), request.specs(), request.last(), caller, entry));
}

absl::StatusOr<v1::GetBatchResponse> OrchestratorHandlers::GetBatch(const v1::GetBatchRequest& request,
                                                                    const Caller& caller) {
  RETURN_IF_ERROR(VisibleBatch(request.batch_id(), caller).status());
  return Answer<v1::GetBatchResponse>(queue_.GetBatch(request.batch_id()));
}

absl::StatusOr<v1::ListBatchesResponse> OrchestratorHandlers::ListBatches(const v1::ListBatchesRequest& request,
                                                                          const Caller& caller) {
  ASSIGN_OR_RETURN(const int limit, PageLimit(request.page_size()));
  ListFilter filter;
  filter.limit = limit + 1;
  filter.before = request.page_token();
  filter.owner = caller.OwnerFilter();
  ASSIGN_OR_RETURN(std::vector<v1::Batch> batches, queue_.ListBatches(filter));
  for (v1::Batch& batch : batches) {
    const absl::StatusOr<v1::Batch> counted = queue_.GetBatch(batch.id());
    // Deleted meanwhile.
    if (!counted.ok() && !absl::IsNotFound(counted.status())) return counted.status();
    if (counted.ok()) batch = *counted;
  }
  return PageOf<v1::ListBatchesResponse>(std::move(batches), limit,
                                         [](v1::ListBatchesResponse& page) { return page.mutable_batches(); });
}

absl::StatusOr<v1::PauseBatchResponse> OrchestratorHandlers::PauseBatch(const v1::PauseBatchRequest& request,
                                                                        const Caller& caller) {
  RETURN_IF_ERROR(VisibleBatch(request.batch_id(), caller).status());
  RETURN_IF_ERROR(queue_.SetBatchState(request.batch_id(), v1::BATCH_STATE_PAUSED));
  return Answer<v1::PauseBatchResponse>(queue_.GetBatch(request.batch_id()));
}

absl::StatusOr<v1::ResumeBatchResponse> OrchestratorHandlers::ResumeBatch(const v1::ResumeBatchRequest& request,
                                                                          const Caller& caller) {
  RETURN_IF_ERROR(VisibleBatch(request.batch_id(), caller).status());
  RETURN_IF_ERROR(queue_.SetBatchState(request.batch_id(), v1::BATCH_STATE_ACTIVE));
  runner_.Request({}, request.batch_id());
  return Answer<v1::ResumeBatchResponse>(queue_.GetBatch(request.batch_id()));
}

absl::StatusOr<v1::CancelBatchResponse> OrchestratorHandlers::CancelBatch(const v1::CancelBatchRequest& request,
                                                                          const Caller& caller) {
  RETURN_IF_ERROR(VisibleBatch(request.batch_id(), caller).status());
  RETURN_IF_ERROR(queue_.CancelBatch(request.batch_id(), clock_.Now()));
  return Answer<v1::CancelBatchResponse>(queue_.GetBatch(request.batch_id()));
}

absl::Status OrchestratorHandlers::RetryJobs(std::span<const v1::Job> jobs, const Caller& caller,
                                             v1::RetryBatchResponse& response) {
  if (jobs.empty()) return absl::OkStatus();
  JobAdmission::Entry entry(admission_, caller);
  ASSIGN_OR_RETURN(const int64_t granted, entry.GrantSome(static_cast<int64_t>(jobs.size())));
  for (const v1::Job& job : jobs.first(static_cast<size_t>(granted))) {
    ASSIGN_OR_RETURN(const bool retried, queue_.Retry(job.id()));
    if (retried) response.set_retried_count(response.retried_count() + 1);
  }
  if (granted == static_cast<int64_t>(jobs.size())) return absl::OkStatus();
  return ResourceExhausted(
      "{} of the failed jobs wait again; more would exceed the limit of waiting jobs; try again later",
      response.retried_count());
}

absl::StatusOr<v1::RetryBatchResponse> OrchestratorHandlers::RetryBatch(const v1::RetryBatchRequest& request,
                                                                        const Caller& caller) {
  ASSIGN_OR_RETURN(const v1::Batch batch, VisibleBatch(request.batch_id(), caller));
  if (batch.state() == v1::BATCH_STATE_CANCELLED) {
    return FailedPrecondition("batch_id: {} is cancelled; make another batch", batch.id());
  }
  if (request.job_ids_size() > kPage) {
    return InvalidArgument("job_ids: {} jobs are too many; at most {}", request.job_ids_size(), kPage);
  }
  // Also for those that wait again when there is no room for the rest.
  runner_.Request({}, batch.id());
  v1::RetryBatchResponse response;
  std::vector<v1::Job> named;
  for (const std::string& id : request.job_ids()) {
    ASSIGN_OR_RETURN(v1::Job job, VisibleJob(id, caller));
    if (IsAskedFor(job, request)) named.push_back(std::move(job));
  }
  RETURN_IF_ERROR(RetryJobs(named, caller, response));
  ListFilter filter;
  filter.limit = kPage;
  filter.batch_id = batch.id();
  filter.state = v1::JOB_STATE_FAILED;
  for (bool more = request.job_ids().empty(); more;) {
    ASSIGN_OR_RETURN(std::vector<v1::Job> jobs, queue_.ListJobs(filter));
    more = jobs.size() == kPage;
    if (more) filter.before = jobs.back().id();
    std::erase_if(jobs, [&](const v1::Job& job) { return !IsAskedFor(job, request); });
    RETURN_IF_ERROR(RetryJobs(jobs, caller, response));
  }
  ASSIGN_OR_RETURN(*response.mutable_batch(), queue_.GetBatch(batch.id()));
  return response;
}

absl::StatusOr<v1::DeleteJobResponse> OrchestratorHandlers::DeleteJob(const v1::DeleteJobRequest& request,
                                                                      const Caller& caller) {
  ASSIGN_OR_RETURN(const v1::Job job, VisibleJob(request.job_id(), caller));
  const absl::StatusOr<Deleted> deleted = queue_.DeleteJob(job.id(), artifacts_);
  if (!deleted.ok()) return Gone(deleted.status(), "job_id", "job", job.id());
  v1::DeleteJobResponse response;
  response.set_deleted_artifact_count(deleted->artifact_count);
  return response;
}

absl::StatusOr<v1::DeleteBatchResponse> OrchestratorHandlers::DeleteBatch(const v1::DeleteBatchRequest& request,
                                                                          const Caller& caller) {
  ASSIGN_OR_RETURN(const v1::Batch batch, VisibleBatch(request.batch_id(), caller));
  const absl::StatusOr<Deleted> deleted = queue_.DeleteBatch(batch.id(), kJobsPerCall, artifacts_);
  if (!deleted.ok()) return Gone(deleted.status(), "batch_id", "batch", batch.id());
  v1::DeleteBatchResponse response;
  response.set_deleted_job_count(deleted->job_count);
  response.set_deleted_artifact_count(deleted->artifact_count);
  response.set_done(deleted->done);
  return response;
}

}  // namespace flair::orchestrator
