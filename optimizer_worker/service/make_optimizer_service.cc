// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/service/make_optimizer_service.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/worker_service.pb.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/constraints/facts.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/conversion/conversion.h"
#include "room/text_format/scene_text.h"
#include "room/validation/validate.h"
#include "worker_runtime/bootstrap/build_id.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/server_call.h"
#include "worker_runtime/logging/log.h"
#include "worker_runtime/metrics/metrics.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

using runtime::MetricFamily;

constexpr MetricFamily kRestarts = runtime::CounterFamily(
    "flair_optimizer_restarts_total",
    "Restarts of the solver: of this program's own solves, wherever they ran, or for a peer.", {"requester"});
constexpr MetricFamily kEvaluations = runtime::CounterFamily(
    "flair_optimizer_evaluations_total", "Evaluations of the cost in these restarts.", {"requester"});
constexpr MetricFamily kConstraints = runtime::CounterFamily("flair_optimizer_constraints_total",
                                                             "Constraints of solved layouts, by outcome.", {"outcome"});
constexpr MetricFamily kStageDuration = runtime::HistogramFamily(
    "flair_optimizer_stage_duration_seconds", "Wall time of a stage of a solve.", runtime::kSecondsBuckets, {"stage"});

double Seconds(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

// Counts what solving took, from the answers: nothing is counted while a solver runs. Thread-safe. `metrics` outlives
// it.
class SolveMetrics {
 public:
  explicit SolveMetrics(runtime::Metrics& metrics)
      : metrics_(metrics),
        own_restarts_(metrics.Get(kRestarts, {"own"})),
        peer_restarts_(metrics.Get(kRestarts, {"peer"})),
        own_evaluations_(metrics.Get(kEvaluations, {"own"})),
        peer_evaluations_(metrics.Get(kEvaluations, {"peer"})),
        satisfied_(metrics.Get(kConstraints, {"satisfied"})),
        violated_(metrics.Get(kConstraints, {"violated"})),
        dropped_(metrics.Get(kConstraints, {"dropped"})) {
    metrics.Declare(kStageDuration);
  }

  // To be told of answers (runtime::ObservedHandler).
  void operator()(const v1::SolveRequest& request, const v1::SolveResponse& response, absl::Duration duration) const;
  // Of restarts done for another optimizer.
  void operator()(const v1::SolveRestartsRequest& request, const v1::SolveRestartsResponse& response,
                  absl::Duration duration) const;

 private:
  runtime::Metrics& metrics_;
  runtime::Meter& own_restarts_;
  runtime::Meter& peer_restarts_;
  runtime::Meter& own_evaluations_;
  runtime::Meter& peer_evaluations_;
  runtime::Meter& satisfied_;
  runtime::Meter& violated_;
  runtime::Meter& dropped_;
};

void SolveMetrics::operator()(const v1::SolveRequest&, const v1::SolveResponse& response, absl::Duration) const {
  const v1::SolvedLayout& layout = response.solved_layout();
  for (const v1::StageOutcome& stage : layout.stage_outcomes()) {
    own_restarts_.Add(stage.restart_count());
    own_evaluations_.Add(static_cast<double>(stage.evaluation_count()));
  }
  const int stage_count = std::min(layout.stage_outcomes_size(), response.stage_durations_size());
  for (int i = 0; i < stage_count; ++i) {
    metrics_.Get(kStageDuration, {layout.stage_outcomes(i).stage()}).Add(Seconds(response.stage_durations(i)));
  }
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) {
    if (edge.status() == v1::OUTCOME_STATUS_SATISFIED) satisfied_.Add();
    if (edge.status() == v1::OUTCOME_STATUS_VIOLATED) violated_.Add();
    if (edge.status() == v1::OUTCOME_STATUS_DROPPED) dropped_.Add();
  }
}

void SolveMetrics::operator()(const v1::SolveRestartsRequest&, const v1::SolveRestartsResponse& response,
                              absl::Duration) const {
  peer_restarts_.Add(response.outcomes_size());
  for (const v1::RestartOutcome& outcome : response.outcomes()) {
    peer_evaluations_.Add(static_cast<double>(outcome.evaluation_count()));
  }
}

class Service final : public runtime::Service {
 public:
  Service(runtime::WorkerContext& worker, std::vector<std::unique_ptr<PeerOptimizer>> peers)
      : runtime::Service(worker, v1::OptimizerService::service_full_name()),
        identity_(PeerIdentity(worker.build)),
        peers_(std::move(peers), worker.clock,
               [&worker](const std::string& remark) { worker.logger->warn("{}", remark); }) {
    Unary<v1::ListConstraintTypesRequest>("ListConstraintTypes", handlers_);
    Unary<v1::SolveRequest>("Solve", counted_);
    Unary<v1::SolveRestartsRequest>("SolveRestarts", counted_);
    Unary<v1::ResolveRequest>("Resolve", handlers_);
    Unary<v1::EvaluateRequest>("Evaluate", handlers_);
  }

 private:
  // Peers look whose restarts they get before these have come.
  absl::Status Admit(grpc::CallbackServerContext& context, runtime::CallContext& call) override {
    context.AddInitialMetadata(kProducerMetadata, identity_);
    return runtime::Service::Admit(context, call);
  }

  const std::string identity_;
  const NloptSolver solver_;
  PeerPool peers_;
  const OptimizerHandlers handlers_{solver_, peers_};
  const SolveMetrics metrics_{worker_.metrics};
  runtime::ObservedHandler<const OptimizerHandlers, const SolveMetrics&> counted_{handlers_, worker_.clock, metrics_};
};

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

absl::StatusOr<std::unique_ptr<grpc::Service>> MakeOptimizerService(const config::v1::OptimizerWorkerConfig& config,
                                                                    runtime::WorkerContext& worker) {
  std::vector<std::unique_ptr<PeerOptimizer>> peers;
  for (int i = 0; i < config.peer_addresses_size(); ++i) {
    absl::StatusOr<std::unique_ptr<PeerOptimizer>> peer =
        MakeGrpcPeer(config.peer_addresses(i), PeerIdentity(worker.build), worker.clock,
                     runtime::ChannelOptionsOf(config.runtime()));
    if (!peer.ok()) {
      return InvalidArgument("peer_addresses[{}]: {}", i, peer.status().message());
    }
    peers.push_back(*std::move(peer));
  }
  worker.capabilities = {v1::CAPABILITY_DETERMINISTIC, v1::CAPABILITY_EVALUATE, v1::CAPABILITY_RESOLVE,
                         v1::CAPABILITY_SOLVE_RESTARTS, v1::CAPABILITY_VARIANTS};
  return std::make_unique<Service>(worker, std::move(peers));
}

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
