// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/optimizer_handlers.h"

#include <fmt/format.h>

#include <utility>

#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/fanout/fan_out.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/conversion/conversion.h"
#include "room/text_format/scene_text.h"
#include "room/validation/validate.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

constexpr double kUsualHeight_m = 0.5;
constexpr double kMarkerExtent_m = 0.1;

// Whether it counts for the mean point of its zone; see ZoneCenters.
bool CountsForZone(const Object& object) {
  return object.kind == ObjectKind::kFloor && object.role != ObjectRole::kTertiary;
}

// Primaries and secondaries stand on the floor and belong to a zone.
void GiveRolesAndZones(Scene& scene) {
  const bool has_zones = !scene.zones.empty();
  if (!has_zones) scene.zones.push_back({.id = "room", .name = "room"});
  for (Object& object : scene.objects) {
    if (object.height_m == 0) object.height_m = kUsualHeight_m;
    const bool zoneless = object.zone < 0 && has_zones;
    if (object.kind != ObjectKind::kFloor || zoneless) object.role = ObjectRole::kTertiary;
    if (object.zone < 0 && !has_zones && CountsForZone(object)) object.zone = 0;
  }
}

// Where one more object of the zone has to stand for the mean point of all to be `center`.
Vec2<double> Counterweight(const SceneText& text, int zone, const Vec2<double>& center) {
  Vec2<double> place = center;
  for (size_t i = 0; i < text.scene.objects.size(); ++i) {
    if (text.scene.objects[i].zone == zone && CountsForZone(text.scene.objects[i])) {
      place += center - Vec2<double>{text.layout[i].x_m, text.layout[i].y_m};
    }
  }
  return place;
}

void MarkZoneCenters(SceneText& text) {
  std::vector<Vec2<double>> places;
  for (size_t zone = 0; zone < text.zone_centers.size(); ++zone) {
    places.push_back(Counterweight(text, static_cast<int>(zone), text.zone_centers[zone]));
  }
  for (size_t zone = 0; zone < places.size(); ++zone) {
    Object marker;
    marker.id = marker.name = text.scene.zones[zone].id + "_marker";
    marker.zone = static_cast<int>(zone);
    marker.footprint = {.width_m = kMarkerExtent_m, .depth_m = kMarkerExtent_m};
    marker.height_m = kMarkerExtent_m;
    text.scene.objects.push_back(std::move(marker));
    text.layout.push_back({.x_m = places[zone].x, .y_m = places[zone].y, .theta_rad = 0});
  }
}

v1::PlacedExample ToMessage(SceneText text, const ConstraintFacts& facts, const LayoutExample& example) {
  GiveRolesAndZones(text.scene);
  MarkZoneCenters(text);
  v1::LayoutGraph graph = GraphFromScene(text.scene);
  v1::PlacedExample message;
  *message.mutable_room() = std::move(*graph.mutable_room());
  message.mutable_room()->set_room_type("room");
  *message.mutable_zone_plan() = std::move(*graph.mutable_zone_plan());
  *message.mutable_object_list() = std::move(*graph.mutable_object_list());
  *message.mutable_placements() = PlacementsFromPoses(text.scene, text.layout);
  for (v1::Argument& argument : ArgumentsFromText(facts.type, example.call))
    *message.add_arguments() = std::move(argument);
  message.set_satisfied(example.satisfied);
  return message;
}

// The layouts of a type's facts as messages that Evaluate takes as they are. What the short texts leave out is filled
// in: a zone for what belongs to none, a usual height, and a small object that keeps a zone's mean point where the text
// has it.
google::protobuf::RepeatedPtrField<v1::PlacedExample> PlacedExamplesOf(const ConstraintFacts& facts) {
  google::protobuf::RepeatedPtrField<v1::PlacedExample> examples;
  for (const LayoutExample& example : facts.layouts) {
    absl::StatusOr<SceneText> text = ParseScene(example.scene);
    // A text that cannot be read is found by the battery of tests.
    if (text.ok()) *examples.Add() = ToMessage(*std::move(text), facts, example);
  }
  return examples;
}

// Who made a layout, without the build, which the runtime adds to every answer.
v1::Producer OptimizerProducer() {
  v1::Producer producer;
  producer.set_program(Library().program);
  producer.set_method("slsqp");
  producer.set_version(Library().version);
  return producer;
}

void WriteDurations(const std::vector<absl::Duration>& durations,
                    google::protobuf::RepeatedPtrField<google::protobuf::Duration>& field) {
  for (absl::Duration duration : durations) {
    google::protobuf::Duration& message = *field.Add();
    message.set_seconds(absl::ToInt64Seconds(duration));
    message.set_nanos(static_cast<int32_t>(absl::ToInt64Nanoseconds(duration % absl::Seconds(1))));
  }
}

}  // namespace

std::string PeerIdentity(const std::string& build) {
  const v1::Producer producer = OptimizerProducer();
  const bool known = !build.empty() && build != "unknown";
  return fmt::format("{} {} {}, build {}", producer.program(), producer.method(), producer.version(),
                     known ? build : "unknown " + runtime::BuildId().substr(0, 12));
}

absl::StatusOr<v1::ListConstraintTypesResponse> OptimizerHandlers::Handle(const v1::ListConstraintTypesRequest& request,
                                                                          runtime::CallContext&) const {
  v1::ListConstraintTypesResponse response;
  *response.mutable_catalog() = MakeCatalog();
  if (!request.with_placed_examples()) return response;
  for (v1::ConstraintType& type : *response.mutable_catalog()->mutable_types()) {
    *type.mutable_placed_examples() = PlacedExamplesOf(*FindConstraint(type.name()));
  }
  return response;
}

absl::StatusOr<v1::SolveResponse> OptimizerHandlers::Handle(const v1::SolveRequest& request,
                                                            runtime::CallContext& call) const {
  const FanOutRestartRunner runner(peers_, request.options());
  absl::StatusOr<SolveResult> result = SolveLayout(
      request.layout_graph(), request.options(), solver_, [&call] { return call.cancelled(); }, runner);
  RETURN_IF_ERROR(call.CheckAlive());
  if (!result.ok()) return result.status();
  v1::SolveResponse response;
  *response.mutable_solved_layout() = std::move(result->layout);
  WriteDurations(result->stage_durations, *response.mutable_stage_durations());
  *response.mutable_producer() = OptimizerProducer();
  return response;
}

absl::StatusOr<v1::SolveRestartsResponse> OptimizerHandlers::Handle(const v1::SolveRestartsRequest& request,
                                                                    runtime::CallContext& call) const {
  absl::StatusOr<std::vector<v1::RestartOutcome>> outcomes =
      SolveStageRestarts(request, solver_, [&call] { return call.cancelled(); });
  RETURN_IF_ERROR(call.CheckAlive());
  if (!outcomes.ok()) return outcomes.status();
  v1::SolveRestartsResponse response;
  for (v1::RestartOutcome& outcome : *outcomes) *response.add_outcomes() = std::move(outcome);
  return response;
}

absl::StatusOr<v1::ResolveResponse> OptimizerHandlers::Handle(const v1::ResolveRequest& request,
                                                              runtime::CallContext& call) const {
  absl::StatusOr<ResolveResult> result = ResolveLayout(request.solved_layout(), request.edits(), request.options(),
                                                       solver_, [&call] { return call.cancelled(); });
  RETURN_IF_ERROR(call.CheckAlive());
  if (!result.ok()) return result.status();
  v1::ResolveResponse response;
  *response.mutable_solved_layout() = std::move(result->layout);
  for (std::string& id : result->moved_ids) *response.add_moved_object_ids() = std::move(id);
  WriteDurations(result->stage_durations, *response.mutable_stage_durations());
  *response.mutable_producer() = OptimizerProducer();
  return response;
}

absl::StatusOr<v1::EvaluateResponse> OptimizerHandlers::Handle(const v1::EvaluateRequest& request,
                                                               runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  RETURN_IF_ERROR(call.CheckAlive());
  return EvaluateLayout(request, solver_);
}

}  // namespace flair::optimizer
