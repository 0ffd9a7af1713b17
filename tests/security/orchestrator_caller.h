// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of an orchestrator by their names, for tests that make all of them.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::testing {

class OrchestratorCaller {
 public:
  // Throws when the channel cannot be made.
  OrchestratorCaller(const std::string& address, const runtime::ChannelOptions& options);

  absl::StatusOr<v1::Job> CreateJob(const std::string& text, const std::string& request_id);
  // Waits for its end.
  absl::StatusOr<v1::Job> EndOf(const std::string& job_id);
  absl::StatusOr<v1::Batch> CreateBatch(const std::string& text, const std::string& request_id, int job_count = 1);
  absl::StatusOr<v1::ListJobsResponse> ListJobs();
  absl::StatusOr<v1::ListBatchesResponse> ListBatches();

  // Every RPC that is about a job, a batch or an artifact, by its name, of that one.
  std::map<std::string, absl::Status> AskAbout(const std::string& job_id, const std::string& batch_id,
                                               const std::string& artifact_id);
  // Those that are about none.
  std::map<std::string, absl::Status> AskForAny();

 private:
  template <typename Request, typename Response>
  using Method = grpc::Status (v1::OrchestratorService::StubInterface::*)(grpc::ClientContext*, const Request&,
                                                                          Response*);
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(Method<Request, Response> method, const Request& request);

  std::unique_ptr<v1::OrchestratorService::Stub> stub_;
};

}  // namespace flair::testing
