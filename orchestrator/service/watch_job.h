// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/server_context.h>
#include <grpcpp/support/server_callback.h>

#include <functional>
#include <mutex>
#include <set>

#include "flair/v1/orchestrator_service.pb.h"
#include "orchestrator/batch/event_hub.h"
#include "orchestrator/store/job_store.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::orchestrator {

// The streams of WatchJob: stored events first, then each as it happens, until the one that ends the job. Thread-safe.
// The arguments outlive the server.
class JobWatches {
 public:
  JobWatches(JobStore& store, EventHub& hub, runtime::WorkerContext& worker)
      : store_(store), hub_(hub), worker_(worker) {}

  grpc::ServerWriteReactor<v1::WatchJobResponse>* Start(const v1::WatchJobRequest& request);

  // Ends all streams with UNAVAILABLE, now and from now on: the server is stopping.
  void Stop();

 private:
  class Watch;
  JobStore& store_;
  EventHub& hub_;
  runtime::WorkerContext& worker_;
  std::mutex mutex_;
  bool stopped_ = false;
  std::set<std::shared_ptr<Watch>> watches_;
};

}  // namespace flair::orchestrator
