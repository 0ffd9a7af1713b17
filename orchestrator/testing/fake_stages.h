// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {

// Stages for tests: small valid answers that depend on the brief's text, every call counted, and a hook that may fail
// or hold a call. Thread-safe.
class FakeStages : public StageClients {
 public:
  // Called first in every call with the RPC's name; its error is the answer.
  using Hook = std::function<absl::Status(std::string_view rpc, Call& call)>;
  explicit FakeStages(Hook hook = nullptr) : hook_(std::move(hook)) {}

  int calls(const std::string& rpc) const;
  int all_calls() const;
  // A solver that answers otherwise, though it seems the same.
  void set_seed_added(int64_t added) { seed_added_ = added; }
  // Nothing: workers that do not say which they are.
  void set_revision(std::optional<std::string> revision) { revision_ = std::move(revision); }

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest&, Call&) override;
  absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest&, Call&) override;
  absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest&, Call&) override;
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest&, Call&) override;
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest&, Call&) override;
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest&, Call&) override;
  absl::StatusOr<v1::CompleteConstraintsResponse> CompleteConstraints(const v1::CompleteConstraintsRequest&,
                                                                      Call&) override;
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest&, Call&) override;
  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest&,
                                                                      Call&) override;
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest&, Call&) override;
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest&, Call&) override;
  absl::StatusOr<v1::ResolveResponse> Resolve(const v1::ResolveRequest& request, Call& call) override;
  // Not known here.
  absl::StatusOr<v1::ExportSceneResponse> ExportScene(const v1::ExportSceneRequest&, Call&) override;
  absl::StatusOr<v1::DrawPlanPartsResponse> DrawPlanParts(const v1::DrawPlanPartsRequest&, Call&) override;
  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest&, Call&) override;
  absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind, Call&) override { return revision_; }

 private:
  absl::Status Begin(std::string_view rpc, Call& call);

  const Hook hook_;
  std::optional<std::string> revision_ = "1";
  int64_t seed_added_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, int, std::less<>> calls_;
};

}  // namespace flair::orchestrator
