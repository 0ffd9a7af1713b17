// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/solve_input.h"

#include <algorithm>
#include <chrono>

#include "optimizer_worker/constraints/registry.h"
#include "room/conversion/conversion.h"

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
  absl::StatusOr<SolveSettings> settings = ReadSettings(options);
  if (!settings.ok()) return settings.status();
  absl::StatusOr<Scene> scene = SceneFromProto(graph);
  if (!scene.ok()) return scene.status();
  std::vector<std::vector<int>> partners = PartnersOf(graph, *scene);
  KeepOut keep_out(scene->room);
  evaluation::WalkGrid walk_grid(scene->room, settings->path_width_m);
  evaluation::WalkGrid fine_walk_grid(scene->room, settings->path_width_m, evaluation::kFineCell_m);
  LinkedPairs linked(*scene, graph.edges());
  std::vector<Pin> pins = PinsOf(graph, *scene);
  std::vector<char> pinned(scene->objects.size(), 0);
  for (const Pin& pin : pins) pinned[pin.object] = 1;
  CancelCheck out_of_time = TimeIsUp(settings->time_limit);
  return SolveInput{graph,
                    *std::move(scene),
                    *std::move(settings),
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
