// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_input.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "optimizer_worker/constraints/registry.h"
#include "room/conversion/conversion.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

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

std::vector<Pin> PinsOf(const v1::LayoutGraph& graph, const Scene& scene) {
  std::vector<Pin> pins;
  for (const v1::Placement& placement : graph.pinned_placements()) {
    pins.push_back({scene.IndexOf(placement.object_id()), {placement.x_m(), placement.y_m(), placement.theta_rad()}});
  }
  return pins;
}

CancelCheck TimeIsUp(absl::Duration limit) {
  if (limit == absl::InfiniteDuration()) return nullptr;
  // The steady clock: setting the computer's clock ends no solve.
  const auto end = std::chrono::steady_clock::now() + absl::ToChronoNanoseconds(limit);
  return [end] { return std::chrono::steady_clock::now() >= end; };
}

}  // namespace

absl::StatusOr<SolveInput> MakeSolveInput(const v1::LayoutGraph& graph, const v1::SolveOptions& options,
                                          const Solver& solver, CancelCheck cancelled) {
  ASSIGN_OR_RETURN(SolveSettings settings, ReadSettings(options));
  ASSIGN_OR_RETURN(Scene scene, SceneFromProto(graph));
  std::vector<std::vector<int>> partners = PartnersOf(graph, scene);
  KeepOut keep_out(scene.room);
  const auto grid = [&scene, &settings](double cell_m) {
    return std::async(std::launch::deferred, [room = scene.room, width_m = settings.path_width_m,
                                              cell_m] { return evaluation::WalkGrid(room, width_m, cell_m); })
        .share();
  };
  std::shared_future<evaluation::WalkGrid> walk_grid = grid(evaluation::kSearchCell_m),
                                           fine_walk_grid = grid(evaluation::kFineCell_m);
  LinkedPairs linked(scene, graph);
  std::vector<Pin> pins = PinsOf(graph, scene);
  std::vector<char> pinned(scene.objects.size(), 0);
  for (const Pin& pin : pins) pinned[pin.object] = 1;
  CancelCheck out_of_time = TimeIsUp(settings.time_limit);
  return SolveInput{graph,
                    std::move(scene),
                    std::move(settings),
                    std::move(pins),
                    std::move(pinned),
                    std::move(partners),
                    std::move(linked),
                    {},
                    std::move(keep_out),
                    std::move(walk_grid),
                    std::move(fine_walk_grid),
                    solver,
                    std::move(cancelled),
                    std::move(out_of_time)};
}

SolveInput WithEdgesOf(const v1::LayoutGraph& graph, const SolveInput& input) {
  return {graph,           input.scene,      input.settings, input.pins,      input.pinned,         input.partners,
          input.linked,    input.groups,     input.keep_out, input.walk_grid, input.fine_walk_grid, input.solver,
          input.cancelled, input.out_of_time};
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

absl::StatusOr<SolveSettings> ReadSettings(const v1::SolveOptions& options) {
  RETURN_IF_ERROR(Validate(options));
  SolveSettings settings;
  const auto take = [](bool given, auto value, auto& target) {
    if (given) target = value;
  };
  settings.seed = static_cast<uint64_t>(options.seed());
  const auto cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  settings.threads = options.thread_count() > 0 ? options.thread_count() : cores;
  take(options.has_max_restart_count(), options.max_restart_count(), settings.max_restarts);
  take(options.has_path_width_m(), options.path_width_m(), settings.path_width_m);
  take(options.has_variant_count(), options.variant_count(), settings.variant_count);
  const v1::Lambdas& lambdas = options.lambdas();
  take(lambdas.has_door_overlap(), lambdas.door_overlap(), settings.lambdas.door_overlap);
  take(lambdas.has_wall_attraction_divisor(), lambdas.wall_attraction_divisor(),
       settings.lambdas.wall_attraction_divisor);
  take(lambdas.has_no_overlap(), lambdas.no_overlap(), settings.lambdas.no_overlap);
  take(lambdas.has_balanced(), lambdas.balanced(), settings.lambdas.balanced);
  take(lambdas.has_in_bounds(), lambdas.in_bounds(), settings.lambdas.in_bounds);
  take(lambdas.has_zone(), lambdas.zone(), settings.lambdas.zone);
  take(lambdas.has_tertiary_in_bounds(), lambdas.tertiary_in_bounds(), settings.lambdas.tertiary_in_bounds);
  take(lambdas.has_on_wall(), lambdas.on_wall(), settings.lambdas.on_wall);
  const v1::Tolerances& tolerances = options.tolerances();
  take(tolerances.has_relative(), tolerances.relative(), settings.tolerances.relative);
  take(tolerances.has_absolute(), tolerances.absolute(), settings.tolerances.absolute);
  take(tolerances.has_max_evaluation_count(), tolerances.max_evaluation_count(), settings.tolerances.max_evaluations);
  if (options.has_time_limit()) {
    settings.time_limit =
        absl::Seconds(options.time_limit().seconds()) + absl::Nanoseconds(options.time_limit().nanos());
  }
  settings.leave_out_misfits = options.misfit_policy() == v1::MISFIT_POLICY_LEAVE_OUT;
  settings.find_contradictions = options.find_contradictions();
  settings.groups = options.groups() != v1::GROUP_POLICY_OFF;
  return settings;
}

}  // namespace flair::optimizer
