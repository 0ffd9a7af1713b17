// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that describe the room: brief, room, zones, objects, style, constraints, cleaning.
#include "absl/strings/ascii.h"
#include "orchestrator/pipeline/model_budget.h"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/files/sha256.h"

namespace flair::orchestrator {
namespace {

// A request with what most language requests begin with.
template <typename Request>
Request Begin(const StageRun& run, std::string_view stage) {
  Request request;
  request.set_request_id(RequestId(run, stage));
  *request.mutable_brief() = Input(run, v1::ARTIFACT_KIND_BRIEF).brief();
  *request.mutable_model_options() = OptionsLeft(run.spec.model_options(), run.model_usage);
  return request;
}

template <typename Request>
Request BeginWithPlan(const StageRun& run, std::string_view stage) {
  Request request = Begin<Request>(run, stage);
  *request.mutable_room() = Input(run, v1::ARTIFACT_KIND_ROOM).room();
  *request.mutable_zone_plan() = Input(run, v1::ARTIFACT_KIND_ZONE_PLAN).zone_plan();
  return request;
}

template <typename Request>
Request BeginWithObjects(const StageRun& run, std::string_view stage) {
  Request request = BeginWithPlan<Request>(run, stage);
  *request.mutable_object_list() = Input(run, v1::ARTIFACT_KIND_OBJECT_LIST).object_list();
  return request;
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
  *artifact.mutable_brief() = run.spec.brief();
  const absl::string_view trimmed = absl::StripAsciiWhitespace(run.spec.brief().text());
  artifact.mutable_brief()->set_text(std::string(trimmed));
  return artifact;
}

absl::StatusOr<v1::Artifact> RunRoom(const StageRun& run) {
  auto response = run.clients.DescribeRoom(Begin<v1::DescribeRoomRequest>(run, "room"), run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_room() = std::move(*response->mutable_room());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunZones(const StageRun& run) {
  auto request = Begin<v1::PlanZonesRequest>(run, "zones");
  *request.mutable_room() = Input(run, v1::ARTIFACT_KIND_ROOM).room();
  auto response = run.clients.PlanZones(request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_zone_plan() = std::move(*response->mutable_zone_plan());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunObjects(const StageRun& run) {
  auto response = run.clients.ListObjects(BeginWithPlan<v1::ListObjectsRequest>(run, "objects"), run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_object_list() = std::move(*response->mutable_object_list());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunStyle(const StageRun& run) {
  auto response = run.clients.ChooseStyle(BeginWithObjects<v1::ChooseStyleRequest>(run, "style"), run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_style_sheet() = std::move(*response->mutable_style_sheet());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunConstraints(const StageRun& run) {
  auto response =
      run.clients.ListConstraints(BeginWithObjects<v1::ListConstraintsRequest>(run, "constraints"), run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_raw_constraint_list() = std::move(*response->mutable_constraint_list());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

absl::StatusOr<v1::Artifact> RunCleaning(const StageRun& run) {
  v1::CleanConstraintsRequest request;
  request.set_request_id(RequestId(run, "cleaning"));
  *request.mutable_model_options() = OptionsLeft(run.spec.model_options(), run.model_usage);
  *request.mutable_room() = Input(run, v1::ARTIFACT_KIND_ROOM).room();
  *request.mutable_object_list() = Input(run, v1::ARTIFACT_KIND_OBJECT_LIST).object_list();
  *request.mutable_constraint_list() = Input(run, v1::ARTIFACT_KIND_RAW_CONSTRAINT_LIST).raw_constraint_list();
  auto response = run.clients.CleanConstraints(request, run.call);
  if (!response.ok()) return response.status();
  v1::Artifact artifact;
  *artifact.mutable_constraint_list() = std::move(*response->mutable_constraint_list());
  *artifact.mutable_producer() = response->producer();
  artifact.mutable_model_calls()->Swap(response->mutable_model_calls());
  return artifact;
}

}  // namespace flair::orchestrator
