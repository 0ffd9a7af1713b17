// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/support/server_callback.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/access/access_control.h"
#include "orchestrator/batch/event_hub.h"
#include "orchestrator/batch/job_runner.h"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Sees to it that jobs which are added stay within the limits: the queue's and each caller's. Exact for all calls of
// this process: what one call may add and has not added yet, no other may. Other orchestrators of the same queue count
// for themselves, so a caller who asks several at once may get as much from each. Thread-safe.
class JobAdmission {
 public:
  // The queue outlives it.
  JobAdmission(WorkQueue& queue, int64_t queued_job_limit) : queue_(queue), queued_job_limit_(queued_job_limit) {}

  // A call that adds jobs, from before they are counted until it has added them.
  class Entry {
   public:
    // Waits for other calls of a caller who has a limit of their own. The admission outlives it; the caller too.
    Entry(JobAdmission& admission, const Caller& caller);
    ~Entry();
    Entry(const Entry&) = delete;
    Entry& operator=(const Entry&) = delete;

    // OK when the call may add `job_count` jobs in all; else RESOURCE_EXHAUSTED, saying which limit they are over.
    absl::Status Grant(int64_t job_count);
    // How many of so many jobs the call may add, from 0 on.
    absl::StatusOr<int64_t> GrantSome(int64_t job_count);

   private:
    struct Counts {
      int64_t queued = 0;
      int64_t open = 0;
    };
    // Keeps so much from the others, and counts what is there and kept by them.
    absl::StatusOr<Counts> Keep(int64_t job_count);
    absl::Status Check(const Counts& counts, int64_t job_count) const;

    JobAdmission& admission_;
    const Caller& caller_;
    // Held while the call lasts; null when the caller has no limit.
    std::shared_ptr<std::mutex> turn_;
    int64_t kept_ = 0;
  };

 private:
  std::shared_ptr<std::mutex> TurnOf(const std::string& owner);

  WorkQueue& queue_;
  const int64_t queued_job_limit_;
  std::mutex mutex_;
  // By calls that have not ended.
  int64_t kept_ = 0;
  // Of the owners of which calls are under way.
  std::map<std::string, std::weak_ptr<std::mutex>> turns_;
};

// Items of a page for a page_size of a request. INVALID_ARGUMENT when out of range.
inline absl::StatusOr<int> PageLimit(int page_size) {
  if (page_size < 0 || page_size > 1000) {
    return InvalidArgument("page_size: {} is out of range [0, 1000]", page_size);
  }
  return page_size == 0 ? 50 : page_size;
}

// The answer whose `field` (Response& to the repeated field) has the first `limit` of the items; one more than these
// says that there is another page.
template <typename Response, typename Item, typename Field>
Response PageOf(std::vector<Item> items, int limit, const Field& field) {
  Response response;
  if (static_cast<int>(items.size()) > limit) {
    items.resize(static_cast<size_t>(limit));
    response.set_next_page_token(items.back().id());
  }
  field(response)->Assign(items.begin(), items.end());
  return response;
}

// Answers the unary RPCs of OrchestratorService, as their comments say; `caller` is who asks. Knows nothing of gRPC.
// Thread-safe. The arguments outlive it.
class OrchestratorHandlers {
 public:
  // `status` says how this process does.
  OrchestratorHandlers(WorkQueue& queue, ArtifactStore& artifacts, JobRunner& runner, const runtime::Clock& clock,
                       int queued_job_limit, std::function<v1::OrchestratorStatus()> status)
      : queue_(queue),
        artifacts_(artifacts),
        runner_(runner),
        clock_(clock),
        admission_(queue, queued_job_limit),
        status_(std::move(status)),
        ids_(clock) {}

  absl::StatusOr<v1::CreateJobResponse> CreateJob(const v1::CreateJobRequest& request, const Caller& caller);
  absl::StatusOr<v1::GetJobResponse> GetJob(const v1::GetJobRequest& request, const Caller& caller);
  absl::StatusOr<v1::ListJobsResponse> ListJobs(const v1::ListJobsRequest& request, const Caller& caller);
  absl::StatusOr<v1::CancelJobResponse> CancelJob(const v1::CancelJobRequest& request, const Caller& caller);
  absl::StatusOr<v1::GetArtifactResponse> GetArtifact(const v1::GetArtifactRequest& request, const Caller& caller);
  absl::StatusOr<v1::GetClusterResponse> GetCluster(const v1::GetClusterRequest& request, const Caller& caller);

  absl::StatusOr<v1::CreateBatchResponse> CreateBatch(const v1::CreateBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::AddToBatchResponse> AddToBatch(const v1::AddToBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::GetBatchResponse> GetBatch(const v1::GetBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::ListBatchesResponse> ListBatches(const v1::ListBatchesRequest& request, const Caller& caller);
  absl::StatusOr<v1::PauseBatchResponse> PauseBatch(const v1::PauseBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::ResumeBatchResponse> ResumeBatch(const v1::ResumeBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::CancelBatchResponse> CancelBatch(const v1::CancelBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::DeleteJobResponse> DeleteJob(const v1::DeleteJobRequest& request, const Caller& caller);
  absl::StatusOr<v1::DeleteBatchResponse> DeleteBatch(const v1::DeleteBatchRequest& request, const Caller& caller);
  absl::StatusOr<v1::RetryBatchResponse> RetryBatch(const v1::RetryBatchRequest& request, const Caller& caller);

  // What the caller may see of a job or a batch, whose counts by state are left out; NOT_FOUND for what is another's.
  absl::StatusOr<v1::Job> VisibleJob(const std::string& id, const Caller& caller);
  absl::StatusOr<v1::Batch> VisibleBatch(const std::string& id, const Caller& caller);

 private:
  v1::Job NewJob(const v1::JobSpec& spec) const;
  absl::Status CheckSpec(const v1::JobSpec& spec, const Caller& caller);
  // What a job with that layout is given.
  absl::StatusOr<GivenArtifact> Given(v1::Artifact layout);
  // OK instead of a refusal for want of room, when the request made its jobs before and so needs none.
  absl::Status UnlessRepeated(const absl::Status& refusal, RequestKind kind, const std::string& request_id,
                              const Caller& caller);
  absl::StatusOr<v1::Batch> Add(const v1::Batch& batch, int64_t first_index,
                                const google::protobuf::RepeatedPtrField<v1::JobSpec>& specs, bool last,
                                const Caller& caller, JobAdmission::Entry& entry);
  // Lets as many of the jobs wait again as there is room for, and counts them.
  absl::Status RetryJobs(std::span<const v1::Job> jobs, const Caller& caller, v1::RetryBatchResponse& response);

  WorkQueue& queue_;
  ArtifactStore& artifacts_;
  JobRunner& runner_;
  const runtime::Clock& clock_;
  JobAdmission admission_;
  const std::function<v1::OrchestratorStatus()> status_;
  JobIdSource ids_;
};

// What a stream reads. Its functions may wait for the queue; they are not called at the same time.
template <typename Response>
struct WatchSource {
  // Of the job or the batch.
  std::string id;
  // What comes next after a sequence number, in order.
  std::function<absl::StatusOr<std::vector<Response>>(int64_t after_sequence)> next;
  // Whether nothing will come after it, when next() finds nothing.
  std::function<absl::StatusOr<bool>(int64_t after_sequence)> has_ended;
  std::function<int64_t(const Response&)> sequence_of;
};

class WatchStream;

// The streams of WatchJob and WatchBatch: what is stored first, then each as it happens, until the last. Thread-safe.
// The arguments outlive the server.
class Watches {
 public:
  Watches(EventHub& hub, runtime::WorkerContext& worker) : hub_(hub), worker_(worker) {}

  // A call whose headers have come: refused unless `admitted`, otherwise what `open` says of its request.
  template <typename Request, typename Response>
  grpc::ServerBidiReactor<grpc::ByteBuffer, Response>* Start(
      const std::string& rpc, const std::string& caller, const absl::Status& admitted,
      std::function<absl::StatusOr<WatchSource<Response>>(const Request&)> open);

  // Ends all streams with UNAVAILABLE, now and from now on: the server is stopping.
  void Stop();
  // Ends those that there are.
  void EndAll(const absl::Status& status);

 private:
  template <typename Response>
  class Stream;
  void Remove(const std::shared_ptr<WatchStream>& stream);

  EventHub& hub_;
  runtime::WorkerContext& worker_;
  std::mutex mutex_;
  bool stopped_ = false;
  std::set<std::shared_ptr<WatchStream>> streams_;
};

// The events of a job, until the one that ends it.
WatchSource<v1::WatchJobResponse> JobSource(WorkQueue& queue, const std::string& job_id);

// The ends of a batch's jobs, until all have ended.
WatchSource<v1::WatchBatchResponse> BatchSource(WorkQueue& queue, const std::string& batch_id);

}  // namespace flair::orchestrator
