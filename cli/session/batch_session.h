// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/channel.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// The batches of an orchestrator, in this process or elsewhere. Every call is made again while the orchestrator is not
// reached, once it has answered: it may be restarting. Thread-safe.
class BatchSession {
 public:
  struct Options {
    // For messages, such as "127.0.0.1:50050" or "this process".
    std::string address;
    // In this process.
    bool embedded = false;
    // How long somebody who has answered before may be silent.
    absl::Duration patience = absl::Minutes(2);
  };

  // `stop` ends every call, with CANCELLED; it must outlive the session.
  BatchSession(std::shared_ptr<grpc::Channel> channel, Options options, runtime::Cancellation& stop);

  // An open batch; the same one when the request made it before.
  absl::StatusOr<v1::Batch> CreateBatch(const std::string& request_id, const std::string& label);
  // Waits, calling `full`, while the queue is full. Otherwise as OrchestratorService.AddToBatch.
  absl::StatusOr<v1::Batch> AddToBatch(const v1::AddToBatchRequest& request,
                                       const std::function<void(const std::string& why)>& full);
  absl::StatusOr<v1::Batch> GetBatch(const std::string& id);
  // Newest first, at most `count`.
  absl::StatusOr<std::vector<v1::Batch>> ListBatches(int count);
  absl::StatusOr<v1::Batch> PauseBatch(const std::string& id);
  absl::StatusOr<v1::Batch> ResumeBatch(const std::string& id);
  absl::StatusOr<v1::Batch> CancelBatch(const std::string& id);
  absl::StatusOr<v1::RetryBatchResponse> RetryBatch(const v1::RetryBatchRequest& request);
  // One step of it.
  absl::StatusOr<v1::DeleteBatchResponse> DeleteBatch(const std::string& id);
  absl::StatusOr<v1::GetClusterResponse> GetCluster();
  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id);

  // Calls `see` for every end after a sequence number until the batch is closed and all its jobs have ended, until
  // `see` returns false, or until `enough` is asked for. Goes on where it was when the connection breaks.
  absl::Status WatchBatch(const std::string& id, int64_t after_sequence, runtime::Cancellation& enough,
                          const std::function<bool(const v1::WatchBatchResponse&)>& see);

  // Whether the calls have been asked to end.
  bool stopped() const { return stop_.cancelled(); }
  const std::string& address() const { return options_.address; }

 private:
  using Stub = v1::OrchestratorService::StubInterface;
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                               const Request& request);
  template <typename Request, typename Response>
  absl::StatusOr<v1::Batch> AskOfBatch(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&, Response*),
                                       const std::string& id);
  // Whether to call again after `status`, which may be that the other side `is_full`; waits before it says yes.
  // `silent_since` is when the first call failed.
  bool TryAgain(const absl::Status& status, bool is_full, absl::Time silent_since, int attempt);
  // Says where nobody answered.
  absl::Status Explain(const absl::Status& status) const;

  const std::unique_ptr<Stub> stub_;
  const Options options_;
  runtime::Cancellation& stop_;
  std::atomic<bool> answered_ = false;
};

// Waits, at most until `stop` is asked for. Returns whether it was.
bool WaitUnlessStopped(runtime::Cancellation& stop, absl::Duration time);

}  // namespace flair::cli
