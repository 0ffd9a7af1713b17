// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/testing/fake_stages.h"

#include <google/protobuf/text_format.h>

#include "tests/fixtures/bedroom.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

template <typename Message>
Message Parse(const std::string& text) {
  Message message;
  google::protobuf::TextFormat::ParseFromString(text, &message);
  return message;
}

v1::Room FakeRoom(const std::string& title) {
  v1::Room room = testing::BedroomRoom();
  room.set_title(title);
  v1::Diagnostic& assumed = *room.add_diagnostics();
  assumed.set_severity(v1::SEVERITY_NOTE);
  assumed.set_code("assumed_door");
  assumed.set_message("One door was assumed.");
  return room;
}

v1::Producer Fake(const char* method) {
  v1::Producer producer;
  producer.set_program("fake");
  producer.set_method(method);
  producer.set_version("1");
  return producer;
}

// As if one call of a model stood behind every answer of a request that says how models may be used.
template <typename Request, typename Response>
absl::Status AskModel(const Request& request, std::string_view step, Response& response) {
  if (!request.has_model_options()) return absl::OkStatus();
  const v1::ModelBudget& budget = request.model_options().budget();
  if (budget.has_call_count() && budget.call_count() < 1) return absl::FailedPreconditionError("no calls are left");
  v1::ModelCall& call = *response.add_model_calls();
  call.set_step(std::string(step));
  call.mutable_usage()->set_call_count(1);
  call.mutable_usage()->set_input_token_count(80);
  call.mutable_usage()->set_output_token_count(20);
  call.mutable_usage()->set_cost_usd(0.25);
  return absl::OkStatus();
}

}  // namespace

absl::Status FakeStages::Begin(std::string_view rpc, Call& call) {
  {
    std::lock_guard lock(mutex_);
    ++calls_[std::string(rpc)];
  }
  return hook_ ? hook_(rpc, call) : absl::OkStatus();
}

int FakeStages::calls(const std::string& rpc) const {
  std::lock_guard lock(mutex_);
  const auto found = calls_.find(rpc);
  return found == calls_.end() ? 0 : found->second;
}

int FakeStages::all_calls() const {
  std::lock_guard lock(mutex_);
  int sum = 0;
  for (const auto& [rpc, count] : calls_) sum += count;
  return sum;
}

absl::StatusOr<v1::DescribeRoomResponse> FakeStages::DescribeRoom(const v1::DescribeRoomRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("DescribeRoom", call));
  v1::DescribeRoomResponse response;
  *response.mutable_room() = FakeRoom(request.brief().text());
  *response.mutable_producer() = Fake("room");
  RETURN_IF_ERROR(AskModel(request, "DescribeRoom", response));
  return response;
}

absl::StatusOr<v1::PlanZonesResponse> FakeStages::PlanZones(const v1::PlanZonesRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("PlanZones", call));
  v1::PlanZonesResponse response;
  *response.mutable_zone_plan() = testing::BedroomZones();
  *response.mutable_producer() = Fake("zones");
  RETURN_IF_ERROR(AskModel(request, "PlanZones", response));
  return response;
}

absl::StatusOr<v1::ListObjectsResponse> FakeStages::ListObjects(const v1::ListObjectsRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("ListObjects", call));
  v1::ListObjectsResponse response;
  *response.mutable_object_list()->add_objects() = testing::BedroomBed("bed_1");
  *response.mutable_producer() = Fake("objects");
  RETURN_IF_ERROR(AskModel(request, "ListObjects", response));
  return response;
}

absl::StatusOr<v1::ChooseStyleResponse> FakeStages::ChooseStyle(const v1::ChooseStyleRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("ChooseStyle", call));
  auto response = Parse<v1::ChooseStyleResponse>(R"pb(style_sheet { name: "plain" summary: "Plain." })pb");
  *response.mutable_producer() = Fake("style");
  RETURN_IF_ERROR(AskModel(request, "ChooseStyle", response));
  return response;
}

absl::StatusOr<v1::ListConstraintsResponse> FakeStages::ListConstraints(const v1::ListConstraintsRequest& request,
                                                                        Call& call) {
  RETURN_IF_ERROR(Begin("ListConstraints", call));
  v1::ListConstraintsResponse response;
  *response.mutable_constraint_list()->add_sentences() = testing::BedroomSentence("bed_1");
  *response.mutable_producer() = Fake("constraints");
  RETURN_IF_ERROR(AskModel(request, "ListConstraints", response));
  return response;
}

absl::StatusOr<v1::CleanConstraintsResponse> FakeStages::CleanConstraints(const v1::CleanConstraintsRequest& request,
                                                                          Call& call) {
  RETURN_IF_ERROR(Begin("CleanConstraints", call));
  v1::CleanConstraintsResponse response;
  *response.mutable_constraint_list() = request.constraint_list();
  *response.mutable_producer() = Fake("cleaning");
  RETURN_IF_ERROR(AskModel(request, "CleanConstraints", response));
  return response;
}

absl::StatusOr<v1::CompleteConstraintsResponse> FakeStages::CompleteConstraints(
    const v1::CompleteConstraintsRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("CompleteConstraints", call));
  v1::CompleteConstraintsResponse response;
  *response.mutable_constraint_list() = request.constraint_list();
  *response.mutable_producer() = Fake("completion");
  return response;
}

absl::StatusOr<v1::ListConstraintTypesResponse> FakeStages::ListConstraintTypes(const v1::ListConstraintTypesRequest&,
                                                                                Call& call) {
  RETURN_IF_ERROR(Begin("ListConstraintTypes", call));
  return Parse<v1::ListConstraintTypesResponse>(R"pb(catalog { library: "fake 1" })pb");
}

absl::StatusOr<v1::TranslateResponse> FakeStages::Translate(const v1::TranslateRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("Translate", call));
  v1::TranslateResponse response;
  v1::LayoutGraph& graph = *response.mutable_layout_graph();
  *graph.mutable_room() = request.room();
  *graph.mutable_zone_plan() = request.zone_plan();
  *graph.mutable_object_list() = request.object_list();
  *graph.mutable_style_sheet() = request.style_sheet();
  *graph.mutable_constraint_list() = request.constraint_list();
  *graph.add_edges() = testing::BedroomEdge("bed_1");
  graph.set_catalog_library(request.catalog().library());
  *response.mutable_producer() = Fake("translation");
  RETURN_IF_ERROR(AskModel(request, "Translate", response));
  return response;
}

absl::StatusOr<v1::SolveResponse> FakeStages::Solve(const v1::SolveRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("Solve", call));
  auto response = Parse<v1::SolveResponse>(R"pb(
    solved_layout {
      placements { object_id: "bed_1" x_m: 2 y_m: 4 theta_rad: 3 }
      edge_outcomes { edge_id: "e1" status: OUTCOME_STATUS_SATISFIED }
    })pb");
  *response.mutable_solved_layout()->mutable_graph() = request.layout_graph();
  response.mutable_solved_layout()->set_total_cost(static_cast<double>(request.options().seed() + seed_added_));
  *response.mutable_producer() = Fake("solve");
  return response;
}

absl::StatusOr<v1::ResolveResponse> FakeStages::Resolve(const v1::ResolveRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("Resolve", call));
  v1::ResolveResponse response;
  *response.mutable_solved_layout() = request.solved_layout();
  return response;
}

absl::StatusOr<v1::ExportSceneResponse> FakeStages::ExportScene(const v1::ExportSceneRequest&, Call&) {
  return absl::UnimplementedError("not known");
}

absl::StatusOr<v1::DrawPlanPartsResponse> FakeStages::DrawPlanParts(const v1::DrawPlanPartsRequest&, Call&) {
  return absl::UnimplementedError("not known");
}

absl::StatusOr<v1::EvaluateResponse> FakeStages::Evaluate(const v1::EvaluateRequest&, Call& call) {
  RETURN_IF_ERROR(Begin("Evaluate", call));
  return Parse<v1::EvaluateResponse>(R"pb(
    edge_outcomes { edge_id: "e1" status: OUTCOME_STATUS_SATISFIED }
    metrics { oob_percent: 0.5 reachable_floor_share: 1 reachable_front_share: 1 }
  )pb");
}

absl::StatusOr<v1::RenderResponse> FakeStages::Render(const v1::RenderRequest& request, Call& call) {
  RETURN_IF_ERROR(Begin("Render", call));
  v1::RenderResponse response;
  v1::Preview& preview = *response.mutable_preview();
  preview.set_view(v1::PREVIEW_VIEW_PLAN);
  preview.set_format(v1::PREVIEW_FORMAT_PNG);
  preview.set_width_px(1600);
  preview.set_height_px(1200);
  preview.set_image("picture of " + request.job_id());
  *response.mutable_producer() = Fake("render");
  return response;
}

}  // namespace flair::orchestrator
