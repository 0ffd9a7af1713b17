// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/support/server_callback.h>

#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/batch/event_hub.h"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::orchestrator {

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
