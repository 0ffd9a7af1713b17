// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::orchestrator {

// What the pipeline asks of the stages, one function per RPC. Each waits for the answer, at most until the deadline of
// `call`, and stops when `call` is cancelled. Knows nothing of gRPC. Thread-safe.
class StageClients {
 public:
  virtual ~StageClients() = default;
  using Call = runtime::CallContext;

  virtual absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest& request,
                                                                      Call& call) = 0;
  virtual absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest& request,
                                                                        Call& call) = 0;
  virtual absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(
      const v1::ListConstraintTypesRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest& request, Call& call) = 0;

  // Tells the worker that a kind of artifact comes from apart from all that may answer otherwise (see WorkerService);
  // empty for what we make ourselves, nothing for workers that do not tell. Part of the key for re-use, so that no
  // worker gets the results of another one or of its own older version. UNIMPLEMENTED for a worker of another protocol.
  virtual absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind kind, Call& call) = 0;
};

}  // namespace flair::orchestrator
