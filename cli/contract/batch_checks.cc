// SPDX-License-Identifier: GPL-3.0-or-later
// Orchestrator: batches that grow, pause, end and are watched. They stay in its store.
#include <grpcpp/client_context.h>

#include <set>

#include "absl/time/clock.h"
#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::contract {
namespace {

v1::CreateBatchRequest OpenBatch(Target& target) {
  v1::CreateBatchRequest request;
  request.set_request_id(target.NewRequestId());
  request.set_open(true);
  return request;
}

v1::AddToBatchRequest Page(const std::string& batch_id, int64_t first, int count, bool last) {
  v1::AddToBatchRequest request;
  request.set_batch_id(batch_id);
  request.set_first_index(first);
  for (int i = 0; i < count; ++i) *request.add_specs() = BedroomJob();
  request.set_last(last);
  return request;
}

// The ends of a batch's jobs, until the stream or the patience ends.
absl::StatusOr<std::vector<v1::WatchBatchResponse>> Watch(const Target& target, const std::string& batch_id,
                                                          int64_t after = 0) {
  const auto stub = v1::OrchestratorService::NewStub(target.channel());
  grpc::ClientContext context;
  context.set_deadline(absl::ToChronoTime(absl::Now() + target.options().patience));
  v1::WatchBatchRequest request;
  request.set_batch_id(batch_id);
  request.set_after_sequence(after);
  const auto reader = stub->WatchBatch(&context, request);
  std::vector<v1::WatchBatchResponse> ends;
  v1::WatchBatchResponse response;
  while (reader->Read(&response)) ends.push_back(response);
  const grpc::Status status = reader->Finish();
  if (!status.ok()) return runtime::FromGrpcStatus(status);
  return ends;
}

// Opens a batch, adds `count` jobs and closes it; then Finding(const std::string& batch_id).
template <typename Judge>
Finding OfABatch(Target& target, int count, const Judge& judge) {
  return Given<v1::CreateBatchResponse>(
      target, "CreateBatch of an open batch", OpenBatch(target), [&](const v1::CreateBatchResponse& created) {
        const std::string& id = created.batch().id();
        return Given<v1::AddToBatchResponse>(target, "AddToBatch", Page(id, 0, count, true),
                                             [&](const v1::AddToBatchResponse&) { return judge(id); });
      });
}

Finding RepeatedBatchesAreOne(Target& target) {
  v1::CreateBatchRequest request;
  request.set_request_id(target.NewRequestId());
  *request.add_specs() = BedroomJob();
  *request.add_specs() = BedroomJob();
  const std::string sent = "CreateBatch of two jobs twice with one request_id";
  return Given<v1::CreateBatchResponse>(target, sent, request, [&](const v1::CreateBatchResponse& first) {
    return Given<v1::CreateBatchResponse>(target, sent, request, [&](const v1::CreateBatchResponse& second) {
      const v1::Batch& batch = second.batch();
      const int counted = batch.open_count() + batch.succeeded_count() + batch.failed_count() + batch.cancelled_count();
      if (batch.id() == first.batch().id() && batch.job_count() == 2 && counted == 2) return Kept();
      return Broken(sent, batch.ShortDebugString(), "the first batch again, of two jobs, with counts that add up");
    });
  });
}

Finding EveryEndComesOnce(Target& target) {
  return OfABatch(target, 3, [&target](const std::string& id) {
    const std::string sent = "WatchBatch of three jobs";
    const auto ends = Watch(target, id);
    if (!ends.ok()) return Broken(sent, StatusText(ends.status()), "three ends");
    std::set<int64_t> places;
    int64_t sequence = 0;
    for (const v1::WatchBatchResponse& end : *ends) {
      const bool ended = end.job().has_end_time() && end.job().batch_id() == id;
      if (!ended || end.sequence() <= sequence) {
        return Broken(sent, end.ShortDebugString(), "ended jobs of the batch, sequences that grow");
      }
      sequence = end.sequence();
      places.insert(end.job().batch_index());
    }
    if (places == std::set<int64_t>{0, 1, 2} && ends->size() == 3) {
      const auto rest = Watch(target, id, (*ends)[1].sequence());
      if (rest.ok() && rest->size() == 1) return Kept();
      return Broken("WatchBatch after the second of three ends",
                    rest.ok() ? fmt::format("{} ends", rest->size()) : StatusText(rest.status()), "the third");
    }
    return Broken(sent, fmt::format("{} ends of {} jobs", ends->size(), places.size()), "one of each place, 0 to 2");
  });
}

Finding PagesMayBeRepeated(Target& target) {
  return Given<v1::CreateBatchResponse>(
      target, "CreateBatch of an open batch", OpenBatch(target), [&](const v1::CreateBatchResponse& created) {
        const v1::AddToBatchRequest page = Page(created.batch().id(), 0, 2, false);
        const std::string sent = "AddToBatch of two jobs twice";
        return Given<v1::AddToBatchResponse>(target, sent, page, [&](const v1::AddToBatchResponse&) {
          return Given<v1::AddToBatchResponse>(target, sent, page, [&](const v1::AddToBatchResponse& again) {
            if (again.batch().job_count() == 2) return Kept();
            return Broken(sent, fmt::format("a batch of {} jobs", again.batch().job_count()), "the same two jobs");
          });
        });
      });
}

// AddToBatch that must be refused.
Finding PageIsRefused(Target& target, const std::string& what, const v1::AddToBatchRequest& page,
                      absl::StatusCode code) {
  const absl::Status status = target.Ask<v1::AddToBatchResponse>(page).status();
  if (status.code() == code) return Kept();
  return Broken("AddToBatch " + what, status.ok() ? "OK" : StatusText(status), absl::StatusCodeToString(code));
}

Finding GapsAreRefused(Target& target) {
  return Given<v1::CreateBatchResponse>(
      target, "CreateBatch of an open batch", OpenBatch(target), [&](const v1::CreateBatchResponse& created) {
        return PageIsRefused(target, "that leaves a gap", Page(created.batch().id(), 5, 1, false),
                             absl::StatusCode::kFailedPrecondition);
      });
}

Finding ClosedBatchesDoNotGrow(Target& target) {
  return OfABatch(target, 1, [&target](const std::string& id) {
    return PageIsRefused(target, "to a closed batch", Page(id, 1, 1, false), absl::StatusCode::kFailedPrecondition);
  });
}

Finding OtherSpecsKeepTheirPlace(Target& target) {
  return OfABatch(target, 1, [&target](const std::string& id) {
    v1::AddToBatchRequest page = Page(id, 0, 1, true);
    page.mutable_specs(0)->mutable_brief()->set_seed(4);
    return PageIsRefused(target, "of another spec to a place that is taken", page, absl::StatusCode::kAlreadyExists);
  });
}

template <typename Request>
Request About(const std::string& batch_id) {
  Request request;
  request.set_batch_id(batch_id);
  return request;
}

Finding PausedJobsWait(Target& target) {
  return Given<v1::CreateBatchResponse>(
      target, "CreateBatch of an open batch", OpenBatch(target), [&](const v1::CreateBatchResponse& created) {
        const std::string id = created.batch().id();
        const std::string sent = "PauseBatch, AddToBatch, another batch to its end, GetBatch of the first";
        const auto paused = target.Ask<v1::PauseBatchResponse>(About<v1::PauseBatchRequest>(id));
        if (!paused.ok()) return Broken(sent, StatusText(paused.status()), "a paused batch");
        const auto added = target.Ask<v1::AddToBatchResponse>(Page(id, 0, 1, true));
        if (!added.ok()) return Broken(sent, StatusText(added.status()), "a job that waits");
        return OfABatch(target, 1, [&](const std::string& other) {
          if (const auto ends = Watch(target, other); !ends.ok()) {
            return Broken(sent, StatusText(ends.status()), "an end of the other batch");
          }
          const auto batch = target.Ask<v1::GetBatchResponse>(About<v1::GetBatchRequest>(id));
          if (!batch.ok()) return Broken(sent, StatusText(batch.status()), "the batch");
          if (batch->batch().open_count() != 1 || batch->batch().state() != v1::BATCH_STATE_PAUSED) {
            return Broken(sent, batch->batch().ShortDebugString(), "a paused batch whose job waits");
          }
          const auto resumed = target.Ask<v1::ResumeBatchResponse>(About<v1::ResumeBatchRequest>(id));
          if (!resumed.ok()) return Broken("ResumeBatch", StatusText(resumed.status()), "an active batch");
          const auto ends = Watch(target, id);
          if (ends.ok() && ends->size() == 1) return Kept();
          return Broken("ResumeBatch, WatchBatch", ends.ok() ? "no end" : StatusText(ends.status()), "the job's end");
        });
      });
}

Finding CancelEndsAllJobs(Target& target) {
  return OfABatch(target, 3, [&target](const std::string& id) {
    const std::string sent = "CancelBatch, WatchBatch, ResumeBatch";
    const auto cancelled = target.Ask<v1::CancelBatchResponse>(About<v1::CancelBatchRequest>(id));
    if (!cancelled.ok()) return Broken(sent, StatusText(cancelled.status()), "a cancelled batch");
    const auto ends = Watch(target, id);
    if (!ends.ok() || ends->size() != 3) {
      return Broken(sent, ends.ok() ? fmt::format("{} ends", ends->size()) : StatusText(ends.status()), "three ends");
    }
    const absl::Status resumed = target.Ask<v1::ResumeBatchResponse>(About<v1::ResumeBatchRequest>(id)).status();
    if (absl::IsFailedPrecondition(resumed)) return Kept();
    return Broken(sent, resumed.ok() ? "OK" : StatusText(resumed), "FAILED_PRECONDITION: it is cancelled for ever");
  });
}

Finding RetryTakesOnlyFailures(Target& target) {
  return OfABatch(target, 1, [&target](const std::string& id) {
    if (const auto ends = Watch(target, id); !ends.ok()) {
      return Broken("WatchBatch of one job", StatusText(ends.status()), "its end");
    }
    return Given<v1::RetryBatchResponse>(target, "RetryBatch of a batch without failures",
                                         About<v1::RetryBatchRequest>(id), [](const v1::RetryBatchResponse& retried) {
                                           if (retried.retried_count() == 0) return Kept();
                                           return Broken("RetryBatch of a batch without failures",
                                                         fmt::format("{} jobs", retried.retried_count()), "none");
                                         });
  });
}

Finding DeletedBatchesAreGone(Target& target) {
  return OfABatch(target, 3, [&target](const std::string& id) {
    const std::string sent = "WatchBatch of three jobs, DeleteBatch until it is done, GetBatch";
    if (const auto ends = Watch(target, id); !ends.ok()) return Broken(sent, StatusText(ends.status()), "three ends");
    int64_t jobs = 0;
    for (bool done = false; !done;) {
      const auto deleted = target.Ask<v1::DeleteBatchResponse>(About<v1::DeleteBatchRequest>(id));
      if (!deleted.ok()) return Broken(sent, StatusText(deleted.status()), "what was deleted");
      if (!deleted->done() && deleted->deleted_job_count() == 0 && deleted->deleted_artifact_count() == 0) {
        return Broken(sent, "nothing deleted, and not done", "every call to go on");
      }
      jobs += deleted->deleted_job_count();
      done = deleted->done();
    }
    if (jobs != 3) return Broken(sent, fmt::format("{} jobs deleted", jobs), "three");
    const absl::Status known = target.Ask<v1::GetBatchResponse>(About<v1::GetBatchRequest>(id)).status();
    if (absl::IsNotFound(known)) return Kept();
    return Broken(sent, known.ok() ? "a batch" : StatusText(known), "NOT_FOUND");
  });
}

Finding OpenBatchesAreNotDeleted(Target& target) {
  return Given<v1::CreateBatchResponse>(
      target, "CreateBatch of an open batch", OpenBatch(target), [&](const v1::CreateBatchResponse& created) {
        const auto request = About<v1::DeleteBatchRequest>(created.batch().id());
        const absl::Status deleted = target.Ask<v1::DeleteBatchResponse>(request).status();
        if (absl::IsFailedPrecondition(deleted)) return Kept();
        return Broken("DeleteBatch of an open batch", deleted.ok() ? "OK" : StatusText(deleted), "FAILED_PRECONDITION");
      });
}

}  // namespace

void AddBatchChecks(Checks& checks) {
  checks.push_back({"A repeated CreateBatch gets the first batch", Promise::kRepetition, RepeatedBatchesAreOne});
  checks.push_back({"WatchBatch tells the end of every job once", Promise::kMessages, EveryEndComesOnce});
  checks.push_back({"A page of jobs may be added again", Promise::kRepetition, PagesMayBeRepeated});
  checks.push_back({"A page that leaves a gap is refused", Promise::kErrors, GapsAreRefused});
  checks.push_back({"A closed batch does not grow", Promise::kErrors, ClosedBatchesDoNotGrow});
  checks.push_back({"A place in a batch keeps its spec", Promise::kRepetition, OtherSpecsKeepTheirPlace});
  checks.push_back({"A paused batch waits and goes on", Promise::kMessages, PausedJobsWait});
  checks.push_back({"CancelBatch ends all jobs for ever", Promise::kCallers, CancelEndsAllJobs});
  checks.push_back({"RetryBatch takes failures only", Promise::kRepetition, RetryTakesOnlyFailures});
  checks.push_back({"DeleteBatch deletes jobs and batch", Promise::kCallers, DeletedBatchesAreGone});
  checks.push_back({"DeleteBatch leaves an open batch alone", Promise::kErrors, OpenBatchesAreNotDeleted});
}

}  // namespace flair::contract
