// SPDX-License-Identifier: GPL-3.0-or-later
// A client of an orchestrator, in this process or elsewhere.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "cli/embedded/embedded_services.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"

namespace flair::cli {

class Session {
 public:
  // To the orchestrator at `address`; when it is empty, to one in this process, with the `stages` that run elsewhere
  // and own ones, which ask `llm`; `orchestrator` as for EmbeddedServices::Start.
  static absl::StatusOr<std::unique_ptr<Session>> Open(const std::string& address,
                                                       const OptionalLlm& llm = std::nullopt,
                                                       const StageFlags& stages = {},
                                                       const config::v1::OrchestratorConfig& orchestrator = {});

  absl::StatusOr<v1::Job> CreateJob(const v1::JobSpec& spec);
  absl::StatusOr<v1::Job> GetJob(const std::string& id);
  absl::StatusOr<v1::Job> CancelJob(const std::string& id);
  absl::StatusOr<v1::DeleteJobResponse> DeleteJob(const std::string& id);
  // Newest first, at most `count`.
  absl::StatusOr<std::vector<v1::Job>> ListJobs(int count);
  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id);
  // Calls `see` for every event until the job ends. Goes on where it was when the connection breaks, a few times.
  absl::Status Watch(const std::string& id, const std::function<void(const v1::JobEvent&)>& see);

  bool embedded() const { return services_ != nullptr; }
  // To the orchestrator, for other classes of calls; "HOST:PORT" or "this process".
  const std::shared_ptr<grpc::Channel>& channel() const { return channel_; }
  const std::string& address() const { return address_; }

 private:
  Session(std::unique_ptr<EmbeddedServices> services, std::shared_ptr<grpc::Channel> channel, std::string address);
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(grpc::Status (v1::OrchestratorService::StubInterface::*method)(grpc::ClientContext*,
                                                                                              const Request&,
                                                                                              Response*),
                               const Request& request);
  // Says where nobody answered.
  absl::Status Explain(const absl::Status& status) const;
  // The same for a call about one job, which may not be there.
  absl::Status ExplainOfJob(const std::string& id, const absl::Status& status) const;

  std::unique_ptr<EmbeddedServices> services_;
  const std::shared_ptr<grpc::Channel> channel_;
  std::unique_ptr<v1::OrchestratorService::Stub> stub_;
  const std::string address_;
};

}  // namespace flair::cli
