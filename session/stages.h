// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

// gRPC's headers are in the .cc file: they cost every file that includes them seconds.
namespace grpc {
class Channel;
}

namespace flair::session {

// Where the services are that an editor needs.
struct Channels {
  std::shared_ptr<grpc::Channel> orchestrator;
  std::shared_ptr<grpc::Channel> translator;
  std::shared_ptr<grpc::Channel> optimizer;
  std::shared_ptr<grpc::Channel> renderer;
};

// The calls that an editor makes of them, under one request_id, each until its caller gives up. Errors are the
// service's. Thread-safe.
class Stages {
 public:
  explicit Stages(const Channels& channels);
  // Jobs that are created and sentences that are translated from now on go there; the rest of the channels is not used.
  // The other orchestrator has the same jobs and artifacts.
  void DesignBy(const Channels& channels);
  ~Stages();

  absl::StatusOr<v1::SolveResponse> Solve(v1::SolveRequest request, runtime::CallContext& call);
  absl::StatusOr<v1::ResolveResponse> Resolve(v1::ResolveRequest request, runtime::CallContext& call);
  absl::StatusOr<v1::EvaluateResponse> Evaluate(v1::EvaluateRequest request, runtime::CallContext& call);
  // The optimizer's, asked once.
  absl::StatusOr<v1::ConstraintCatalog> Catalog(runtime::CallContext& call);
  absl::StatusOr<v1::TranslateResponse> Translate(v1::TranslateRequest request, runtime::CallContext& call);
  absl::StatusOr<v1::RenderResponse> Render(v1::RenderRequest request, runtime::CallContext& call);
  absl::StatusOr<v1::ExportSceneResponse> ExportScene(v1::ExportSceneRequest request, runtime::CallContext& call);
  absl::StatusOr<v1::DrawPlanPartsResponse> DrawPlanParts(v1::DrawPlanPartsRequest request, runtime::CallContext& call);

  absl::StatusOr<v1::Job> CreateJob(const v1::CreateJobRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::Job> GetJob(const std::string& id, runtime::CallContext& call);
  // The newest thousand.
  absl::StatusOr<std::vector<v1::Job>> ListJobs(runtime::CallContext& call);
  absl::Status CancelJob(const std::string& id, runtime::CallContext& call);
  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id, runtime::CallContext& call);
  // Calls `see` for every event after a sequence number until the job ends.
  absl::Status WatchJob(const std::string& id, int64_t after_sequence,
                        const std::function<void(const v1::JobEvent&)>& see, runtime::CallContext& call);

 private:
  struct Stubs;
  struct Designer;
  std::shared_ptr<Designer> DesignerNow();

  const std::unique_ptr<Stubs> stubs_;
  std::mutex mutex_;
  std::shared_ptr<Designer> designer_;
  std::optional<v1::ConstraintCatalog> catalog_;
};

}  // namespace flair::session
