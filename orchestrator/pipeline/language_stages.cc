// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that describe the room: brief, room, zones, objects, style, constraints, cleaning.
#include "orchestrator/pipeline/lent_request.h"
#include "orchestrator/pipeline/model_budget.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"

namespace flair::orchestrator {
namespace {

// What most language requests begin with.
template <typename Request>
void Begin(const StageRun& run, std::string_view stage, LentRequest<Request>& request) {
  request->set_request_id(RequestId(run, stage));
  request.Lend(&Request::unsafe_arena_set_allocated_brief, Input(run, v1::ARTIFACT_KIND_BRIEF).brief());
  *request->mutable_model_options() = OptionsLeft(run.spec.model_options(), run.model_usage);
}

template <typename Request>
void LendRoom(const StageRun& run, LentRequest<Request>& request) {
  request.Lend(&Request::unsafe_arena_set_allocated_room, Input(run, v1::ARTIFACT_KIND_ROOM).room());
}

template <typename Request>
void BeginWithPlan(const StageRun& run, std::string_view stage, LentRequest<Request>& request) {
  Begin(run, stage, request);
  LendRoom(run, request);
  request.Lend(&Request::unsafe_arena_set_allocated_zone_plan, Input(run, v1::ARTIFACT_KIND_ZONE_PLAN).zone_plan());
}

template <typename Request>
void LendObjects(const StageRun& run, LentRequest<Request>& request) {
  request.Lend(&Request::unsafe_arena_set_allocated_object_list,
               Input(run, v1::ARTIFACT_KIND_OBJECT_LIST).object_list());
}

}  // namespace

std::string AskedBrief(const v1::JobSpec& spec) { return runtime::CanonicalBytes(spec.brief()); }

std::string AskedOfModels(const v1::JobSpec& spec) {
  return runtime::CanonicalBytes(DecidingOptions(spec.model_options()));
}

absl::StatusOr<v1::Artifact> RunBrief(const StageRun& run) {
  v1::Artifact artifact;
  artifact.mutable_producer()->set_program("flair-orchestrator");
  artifact.mutable_producer()->set_method("request");
  artifact.mutable_producer()->set_version("1");
  artifact.mutable_producer()->set_build(run.build);
  *artifact.mutable_brief() = BriefOf(run.spec);
  return artifact;
}

absl::StatusOr<v1::Artifact> RunRoom(const StageRun& run) {
  LentRequest<v1::DescribeRoomRequest> request;
  Begin(run, "room", request);
  auto response = run.clients.DescribeRoom(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_room() = std::move(*response->mutable_room());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunZones(const StageRun& run) {
  LentRequest<v1::PlanZonesRequest> request;
  Begin(run, "zones", request);
  LendRoom(run, request);
  auto response = run.clients.PlanZones(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_zone_plan() = std::move(*response->mutable_zone_plan());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunObjects(const StageRun& run) {
  LentRequest<v1::ListObjectsRequest> request;
  BeginWithPlan(run, "objects", request);
  auto response = run.clients.ListObjects(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_object_list() = std::move(*response->mutable_object_list());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunStyle(const StageRun& run) {
  LentRequest<v1::ChooseStyleRequest> request;
  BeginWithPlan(run, "style", request);
  LendObjects(run, request);
  auto response = run.clients.ChooseStyle(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_style_sheet() = std::move(*response->mutable_style_sheet());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunConstraints(const StageRun& run) {
  LentRequest<v1::ListConstraintsRequest> request;
  BeginWithPlan(run, "constraints", request);
  LendObjects(run, request);
  auto response = run.clients.ListConstraints(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_raw_constraint_list() = std::move(*response->mutable_constraint_list());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunCleaning(const StageRun& run) {
  LentRequest<v1::CleanConstraintsRequest> request;
  request->set_request_id(RequestId(run, "cleaning"));
  *request->mutable_model_options() = OptionsLeft(run.spec.model_options(), run.model_usage);
  LendRoom(run, request);
  LendObjects(run, request);
  request.Lend(&v1::CleanConstraintsRequest::unsafe_arena_set_allocated_constraint_list,
               Input(run, v1::ARTIFACT_KIND_RAW_CONSTRAINT_LIST).raw_constraint_list());
  auto response = run.clients.CleanConstraints(*request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_constraint_list() = std::move(*response->mutable_constraint_list());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

}  // namespace flair::orchestrator
