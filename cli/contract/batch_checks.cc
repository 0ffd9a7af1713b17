// SPDX-License-Identifier: GPL-3.0-or-later
// Orchestrator: batches. These checks give it real jobs, which stay in its store.
#include <set>

#include "cli/contract/bedroom.h"
#include "cli/contract/stage_checks.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

template <typename Request>
Request OfBatch(const std::string& id) {
  Request request;
  request.set_batch_id(id);
  return request;
}

// The id of an open batch without jobs.
absl::StatusOr<std::string> OpenBatch(Target& target) {
  v1::CreateBatchRequest request;
  request.set_request_id(target.NewRequestId());
  request.set_open(true);
  ASSIGN_OR_RETURN(const v1::CreateBatchResponse created, target.Ask<v1::CreateBatchResponse>(request));
  return created.batch().id();
}

v1::AddToBatchRequest Page(const std::string& batch_id, int64_t first, int count, bool last) {
  auto request = OfBatch<v1::AddToBatchRequest>(batch_id);
  request.set_first_index(first);
  for (int i = 0; i < count; ++i) *request.add_specs() = BedroomJob();
  request.set_last(last);
  return request;
}

// The id of a closed batch of `count` jobs.
absl::StatusOr<std::string> ClosedBatch(Target& target, int count) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  RETURN_IF_ERROR(target.AskForBytes(Page(id, 0, count, true)).status());
  return id;
}

// The ends of a batch's jobs, until the stream or the patience ends; other than `count` of them are an error.
absl::StatusOr<std::vector<v1::WatchBatchResponse>> WatchBatch(const Target& target, const std::string& id,
                                                               size_t count, int64_t after = 0) {
  auto request = OfBatch<v1::WatchBatchRequest>(id);
  request.set_after_sequence(after);
  ASSIGN_OR_RETURN(auto ends, target.Stream<v1::WatchBatchResponse>(std::vector{request}));
  if (ends.size() == count) return ends;
  return absl::UnknownError(fmt::format("{} ends where {} were due", ends.size(), count));
}

Finding RepeatedBatchesAreOne(Target& target) {
  v1::CreateBatchRequest request;
  request.set_request_id(target.NewRequestId());
  *request.add_specs() = BedroomJob();
  *request.add_specs() = BedroomJob();
  ASSIGN_OR_RETURN(const v1::CreateBatchResponse first, target.Ask<v1::CreateBatchResponse>(request));
  ASSIGN_OR_RETURN(const v1::CreateBatchResponse second, target.Ask<v1::CreateBatchResponse>(request));
  const v1::Batch& batch = second.batch();
  const int counted = batch.open_count() + batch.succeeded_count() + batch.failed_count() + batch.cancelled_count();
  const bool same = batch.id() == first.batch().id() && batch.job_count() == 2 && counted == 2;
  return same ? Kept() : Wrong(batch.ShortDebugString());
}

Finding EveryEndComesOnce(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 3));
  ASSIGN_OR_RETURN(const auto ends, WatchBatch(target, id, 3));
  std::set<int64_t> places;
  int64_t sequence = 0;
  for (const v1::WatchBatchResponse& end : ends) {
    const bool ended = end.job().has_end_time() && end.job().batch_id() == id;
    if (!ended || end.sequence() <= sequence) return Wrong(end.ShortDebugString());
    sequence = end.sequence();
    places.insert(end.job().batch_index());
  }
  if (places != std::set<int64_t>{0, 1, 2}) return Wrong(fmt::format("ends of {} jobs", places.size()));
  return WatchBatch(target, id, 1, ends[1].sequence()).status();
}

Finding PagesMayBeRepeated(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  const v1::AddToBatchRequest page = Page(id, 0, 2, false);
  RETURN_IF_ERROR(target.AskForBytes(page).status());
  ASSIGN_OR_RETURN(const v1::AddToBatchResponse again, target.Ask<v1::AddToBatchResponse>(page));
  return again.batch().job_count() == 2 ? Kept() : Wrong(fmt::format("a batch of {} jobs", again.batch().job_count()));
}

Finding GapsAreRefused(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  return RefusedAs(absl::StatusCode::kFailedPrecondition, target.AskForBytes(Page(id, 5, 1, false)).status());
}

Finding ClosedBatchesDoNotGrow(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 1));
  return RefusedAs(absl::StatusCode::kFailedPrecondition, target.AskForBytes(Page(id, 1, 1, false)).status());
}

Finding OtherSpecsKeepTheirPlace(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 1));
  v1::AddToBatchRequest page = Page(id, 0, 1, true);
  page.mutable_specs(0)->mutable_brief()->set_seed(4);
  return RefusedAs(absl::StatusCode::kAlreadyExists, target.AskForBytes(page).status());
}

Finding PausedJobsWait(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  RETURN_IF_ERROR(target.AskForBytes(OfBatch<v1::PauseBatchRequest>(id)).status());
  RETURN_IF_ERROR(target.AskForBytes(Page(id, 0, 1, true)).status());
  ASSIGN_OR_RETURN(const std::string other, ClosedBatch(target, 1));
  RETURN_IF_ERROR(WatchBatch(target, other, 1).status());
  ASSIGN_OR_RETURN(const auto paused, target.Ask<v1::GetBatchResponse>(OfBatch<v1::GetBatchRequest>(id)));
  if (paused.batch().open_count() != 1 || paused.batch().state() != v1::BATCH_STATE_PAUSED) {
    return Wrong(paused.batch().ShortDebugString());
  }
  RETURN_IF_ERROR(target.AskForBytes(OfBatch<v1::ResumeBatchRequest>(id)).status());
  return WatchBatch(target, id, 1).status();
}

Finding CancelEndsAllJobs(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 3));
  RETURN_IF_ERROR(target.AskForBytes(OfBatch<v1::CancelBatchRequest>(id)).status());
  RETURN_IF_ERROR(WatchBatch(target, id, 3).status());
  return RefusedAs(absl::StatusCode::kFailedPrecondition,
                   target.AskForBytes(OfBatch<v1::ResumeBatchRequest>(id)).status());
}

Finding RetryTakesOnlyFailures(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 1));
  RETURN_IF_ERROR(WatchBatch(target, id, 1).status());
  ASSIGN_OR_RETURN(const auto retried, target.Ask<v1::RetryBatchResponse>(OfBatch<v1::RetryBatchRequest>(id)));
  return retried.retried_count() == 0 ? Kept() : Wrong(fmt::format("{} jobs", retried.retried_count()));
}

Finding DeletedBatchesAreGone(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, ClosedBatch(target, 3));
  RETURN_IF_ERROR(WatchBatch(target, id, 3).status());
  int64_t jobs = 0;
  for (bool done = false; !done;) {
    ASSIGN_OR_RETURN(const auto deleted, target.Ask<v1::DeleteBatchResponse>(OfBatch<v1::DeleteBatchRequest>(id)));
    if (!deleted.done() && deleted.deleted_job_count() == 0 && deleted.deleted_artifact_count() == 0) {
      return Wrong("nothing deleted, and not done", "every call to go on");
    }
    jobs += deleted.deleted_job_count();
    done = deleted.done();
  }
  if (jobs != 3) return Wrong(fmt::format("{} jobs deleted", jobs), "three");
  return RefusedAs(absl::StatusCode::kNotFound, target.AskForBytes(OfBatch<v1::GetBatchRequest>(id)).status());
}

Finding OpenBatchesAreNotDeleted(Target& target) {
  ASSIGN_OR_RETURN(const std::string id, OpenBatch(target));
  return RefusedAs(absl::StatusCode::kFailedPrecondition,
                   target.AskForBytes(OfBatch<v1::DeleteBatchRequest>(id)).status());
}

}  // namespace

Checks BatchChecks() {
  return {
      {"A repeated CreateBatch gets the first batch", Promise::kRepetition,
       "CreateBatch of two jobs twice with one request_id",
       "the first batch again, of two jobs, with counts that add up", RepeatedBatchesAreOne},
      {"WatchBatch tells the end of every job once", Promise::kMessages,
       "WatchBatch of three jobs, and again after the second end",
       "one end of each place, 0 to 2, with sequences that grow; then the third alone", EveryEndComesOnce},
      {"A page of jobs may be added again", Promise::kRepetition, "AddToBatch of two jobs twice", "the same two jobs",
       PagesMayBeRepeated},
      {"A page that leaves a gap is refused", Promise::kErrors, "AddToBatch that leaves a gap", "FAILED_PRECONDITION",
       GapsAreRefused},
      {"A closed batch does not grow", Promise::kErrors, "AddToBatch to a closed batch", "FAILED_PRECONDITION",
       ClosedBatchesDoNotGrow},
      {"A place in a batch keeps its spec", Promise::kRepetition, "AddToBatch of another spec to a place that is taken",
       "ALREADY_EXISTS", OtherSpecsKeepTheirPlace},
      {"A paused batch waits and goes on", Promise::kMessages,
       "PauseBatch, AddToBatch, another batch to its end, GetBatch, ResumeBatch, WatchBatch",
       "a paused batch whose job waits, and the job's end after ResumeBatch", PausedJobsWait},
      {"CancelBatch ends all jobs for ever", Promise::kCallers, "CancelBatch, WatchBatch, ResumeBatch",
       "three ends, then FAILED_PRECONDITION", CancelEndsAllJobs},
      {"RetryBatch takes failures only", Promise::kRepetition, "RetryBatch of a batch without failures", "no jobs",
       RetryTakesOnlyFailures},
      {"DeleteBatch deletes jobs and batch", Promise::kCallers,
       "WatchBatch of three jobs, DeleteBatch until it is done, GetBatch", "three jobs deleted, then NOT_FOUND",
       DeletedBatchesAreGone},
      {"DeleteBatch leaves an open batch alone", Promise::kErrors, "DeleteBatch of an open batch",
       "FAILED_PRECONDITION", OpenBatchesAreNotDeleted},
  };
}

}  // namespace flair::contract
