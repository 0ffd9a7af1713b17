// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "flair/v1/job.pb.h"
#include "orchestrator/pipeline/stage_clients.h"

namespace flair::orchestrator {

// Answers at once, as the workers of one furnished room.
class RecordedStages final : public StageClients {
 public:
  // Of the design in $FLAIR_BENCH_DESIGN, else in "out": layout.pb and plan.png, as `flair design` writes them.
  RecordedStages();

  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest&, Call&) override {
    v1::DescribeRoomResponse response;
    *response.mutable_room() = graph_.room();
    return response;
  }
  absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest&, Call&) override {
    v1::PlanZonesResponse response;
    *response.mutable_zone_plan() = graph_.zone_plan();
    return response;
  }
  absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest&, Call&) override {
    v1::ListObjectsResponse response;
    *response.mutable_object_list() = graph_.object_list();
    return response;
  }
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest&, Call&) override {
    v1::ChooseStyleResponse response;
    *response.mutable_style_sheet() = graph_.style_sheet();
    return response;
  }
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest&, Call&) override {
    v1::ListConstraintsResponse response;
    *response.mutable_constraint_list() = graph_.constraint_list();
    return response;
  }
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest&, Call&) override {
    v1::CleanConstraintsResponse response;
    *response.mutable_constraint_list() = graph_.constraint_list();
    return response;
  }
  absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest&, Call&) override {
    v1::TranslateResponse response;
    *response.mutable_layout_graph() = graph_;
    return response;
  }
  absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(const v1::ListConstraintTypesRequest&,
                                                                      Call&) override {
    return catalog_;
  }
  absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest&, Call&) override {
    v1::SolveResponse response;
    *response.mutable_solved_layout() = layout_;
    return response;
  }
  absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest&, Call&) override {
    v1::EvaluateResponse response;
    *response.mutable_edge_outcomes() = layout_.edge_outcomes();
    *response.mutable_metrics() = layout_.metrics();
    return response;
  }
  absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest&, Call&) override {
    v1::RenderResponse response;
    v1::Preview& preview = *response.mutable_preview();
    preview.set_view(v1::PREVIEW_VIEW_PLAN);
    preview.set_format(v1::PREVIEW_FORMAT_PNG);
    preview.set_width_px(1600);
    preview.set_height_px(1200);
    preview.set_image(picture_);
    return response;
  }
  absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind, Call&) override { return "1"; }

 private:
  v1::SolvedLayout layout_;
  v1::LayoutGraph graph_;
  std::string picture_;
  v1::ListConstraintTypesResponse catalog_;
};

// The brief of a room that no other number has.
v1::JobSpec SpecOf(int64_t number);

}  // namespace flair::orchestrator
