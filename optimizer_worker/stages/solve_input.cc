// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_input.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/solver/parallel.h"
#include "room/conversion/scene_conversion.h"

namespace flair::optimizer {
namespace {

absl::Status ReadLambda(bool given, double value, const char* name, double& target) {
  if (!given) return absl::OkStatus();
  if (!std::isfinite(value) || value < 0) {
    return absl::InvalidArgumentError(fmt::format("options.lambdas.{}: {} is not a number >= 0", name, value));
  }
  target = value;
  return absl::OkStatus();
}

absl::Status ReadLambdas(const v1::Lambdas& from, LambdaValues& to) {
  for (const absl::Status& status : {
           ReadLambda(from.has_door_overlap(), from.door_overlap(), "door_overlap", to.door_overlap),
           ReadLambda(from.has_wall_attraction_divisor(), from.wall_attraction_divisor(), "wall_attraction_divisor",
                      to.wall_attraction_divisor),
           ReadLambda(from.has_no_overlap(), from.no_overlap(), "no_overlap", to.no_overlap),
           ReadLambda(from.has_balanced(), from.balanced(), "balanced", to.balanced),
           ReadLambda(from.has_in_bounds(), from.in_bounds(), "in_bounds", to.in_bounds),
           ReadLambda(from.has_zone(), from.zone(), "zone", to.zone),
           ReadLambda(from.has_tertiary_in_bounds(), from.tertiary_in_bounds(), "tertiary_in_bounds",
                      to.tertiary_in_bounds),
           ReadLambda(from.has_on_wall(), from.on_wall(), "on_wall", to.on_wall),
       }) {
    if (!status.ok()) return status;
  }
  return absl::OkStatus();
}

std::vector<std::vector<int>> PartnersOf(const v1::LayoutGraph& graph, const Scene& scene) {
  std::vector<std::vector<int>> partners(scene.objects.size());
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    const std::vector<int> objects = NamedObjects(edge, scene);
    for (int a : objects) {
      for (int b : objects) {
        std::vector<int>& list = partners[a];
        if (a != b && std::find(list.begin(), list.end(), b) == list.end()) list.push_back(b);
      }
    }
  }
  return partners;
}

}  // namespace

absl::StatusOr<SolveSettings> ReadSettings(const v1::SolveOptions& options) {
  SolveSettings settings;
  settings.seed = static_cast<uint64_t>(options.seed());
  if (options.seed() < 0) {
    return absl::InvalidArgumentError(fmt::format("options.seed: {} is negative", options.seed()));
  }
  if (options.has_max_restart_count() && (options.max_restart_count() < 1 || options.max_restart_count() > 10000)) {
    return absl::InvalidArgumentError(
        fmt::format("options.max_restart_count: {} is not in [1, 10000]", options.max_restart_count()));
  }
  settings.max_restarts = options.max_restart_count();
  if (options.has_thread_count() && (options.thread_count() < 1 || options.thread_count() > 256)) {
    return absl::InvalidArgumentError(
        fmt::format("options.thread_count: {} is not in [1, 256]", options.thread_count()));
  }
  settings.threads = ThreadCount(options.thread_count());
  if (options.has_path_width_m()) settings.path_width_m = options.path_width_m();
  if (!std::isfinite(settings.path_width_m) || settings.path_width_m < 0 || settings.path_width_m > 2) {
    return absl::InvalidArgumentError(fmt::format("options.path_width_m: {} is not in [0, 2]", settings.path_width_m));
  }
  const absl::Status status = ReadLambdas(options.lambdas(), settings.lambdas);
  if (!status.ok()) return status;
  return settings;
}

absl::StatusOr<SolveInput> MakeSolveInput(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                          const Solver& solver, CancelCheck cancelled) {
  absl::StatusOr<SolveSettings> settings = ReadSettings(options);
  if (!settings.ok()) return settings.status();
  absl::StatusOr<Scene> scene = SceneFromProto(graph);
  if (!scene.ok()) return scene.status();
  std::vector<std::vector<int>> partners = PartnersOf(graph, *scene);
  KeepOut keep_out(scene->room);
  WalkGrid walk_grid(scene->room, settings->path_width_m);
  LinkedPairs linked(*scene, graph.edges());
  return SolveInput{graph,
                    *std::move(scene),
                    *std::move(settings),
                    std::move(partners),
                    std::move(linked),
                    std::move(keep_out),
                    std::move(walk_grid),
                    solver,
                    std::move(cancelled)};
}

std::vector<Vec2<double>> ZoneCenters(const Scene& scene, std::span<const char> placed, const Layout& layout) {
  std::vector<Vec2<double>> centers(scene.zones.size(), Vec2<double>{0, 0});
  std::vector<int> counts(scene.zones.size(), 0);
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (!placed[i] || object.zone < 0 || object.kind != ObjectKind::kFloor || object.role == ObjectRole::kTertiary)
      continue;
    centers[object.zone] += Center(layout[i]);
    ++counts[object.zone];
  }
  for (size_t z = 0; z < centers.size(); ++z) {
    centers[z] = counts[z] > 0 ? (1.0 / counts[z]) * centers[z] : Vec2<double>{kEmptyZone_m, kEmptyZone_m};
  }
  return centers;
}

}  // namespace flair::optimizer
