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
#include "cli/input/artifact_shelf.h"
#include "cli/output/report_text.h"
#include "cli/progress/progress.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"

namespace flair::cli {

class Session final : public ArtifactShelf {
 public:
  // To the orchestrator at `address`; when it is empty, to one in this process, with the `stages` that run elsewhere
  // and own ones, which ask `llm`; `orchestrator` as for EmbeddedServices::Start.
  static absl::StatusOr<std::unique_ptr<Session>> Open(const std::string& address,
                                                       const OptionalLlm& llm = std::nullopt,
                                                       const StageChoice& stages = {},
                                                       const config::v1::OrchestratorConfig& orchestrator = {});

  absl::StatusOr<v1::Job> CreateJob(const v1::JobSpec& spec);
  absl::StatusOr<v1::Job> GetJob(const std::string& id) override;
  absl::StatusOr<v1::Job> CancelJob(const std::string& id);
  absl::StatusOr<v1::DeleteJobResponse> DeleteJob(const std::string& id);
  // Newest first, at most `count`.
  absl::StatusOr<std::vector<v1::Job>> ListJobs(int count);
  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) override;
  // Among the latest 1000 jobs.
  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) override;
  std::string name() const override { return "the orchestrator at " + address_; }
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

// How a job ended, and what came of it.

// What a failed job ends the program with. A model's failures have an exit code of their own.
absl::Status ErrorOf(const v1::Job& job);

// Shows `progress` what happens until the job ends; OK when it succeeded.
absl::Status WaitForJob(Session& session, const std::string& id, Progress& progress);

// The artifacts that a job has stored so far. DATA_LOSS when one is not what it was.
absl::StatusOr<ArtifactsByKind> StoredArtifacts(Session& session, const v1::Job& job);

// The same of a job that succeeded, with a layout and a picture.
absl::StatusOr<ArtifactsByKind> CollectArtifacts(Session& session, const v1::Job& job);

}  // namespace flair::cli
