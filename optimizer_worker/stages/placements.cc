// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/placements.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {

namespace {

double UndersideOf(const SolveInput& input, int object, const PartialLayout& state) {
  const Scene& scene = input.scene;
  const Object& what = scene.objects[object];
  switch (what.kind) {
    case ObjectKind::kFloor:
    case ObjectKind::kWall:
      return what.elevation_m;
    case ObjectKind::kCeiling:
      return std::max(0.0, scene.room.height_m - what.height_m);
    case ObjectKind::kSurface: {
      const int carrier = CarrierOf(scene, object, state);
      return what.elevation_m + (carrier >= 0 ? scene.TopOf(carrier) : 0.0);
    }
  }
  return 0;
}

}  // namespace

std::vector<v1::Placement> MakePlacements(const SolveInput& input, const PartialLayout& state) {
  std::vector<v1::Placement> placements;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (!state.placed[i]) continue;
    v1::Placement& placement = placements.emplace_back();
    placement.set_object_id(input.scene.objects[i].id);
    placement.set_x_m(state.layout[i].x_m + 0.0);
    placement.set_y_m(state.layout[i].y_m + 0.0);
    placement.set_z_m(UndersideOf(input, i, state));
    placement.set_theta_rad(WrapHeading(state.layout[i].theta_rad));
  }
  return placements;
}

absl::Status ReadPlacements(const SolveInput& input,
                            const google::protobuf::RepeatedPtrField<v1::Placement>& placements, PartialLayout& state) {
  for (int i = 0; i < placements.size(); ++i) {
    const v1::Placement& placement = placements[i];
    const int object = input.scene.IndexOf(placement.object_id());
    if (object < 0) {
      return absl::InvalidArgumentError(
          fmt::format("placements[{}].object_id: \"{}\" is not an object of the graph", i, placement.object_id()));
    }
    if (!std::isfinite(placement.x_m()) || !std::isfinite(placement.y_m()) || !std::isfinite(placement.theta_rad())) {
      return absl::InvalidArgumentError(
          fmt::format("placements[{}]: the pose of \"{}\" is not finite", i, placement.object_id()));
    }
    state.Place(object, {placement.x_m(), placement.y_m(), placement.theta_rad()});
  }
  return absl::OkStatus();
}

namespace {

constexpr int kFurnishSweeps = 3;
constexpr double kFurnishNoise = 0.3;

std::vector<int> OrderOf(const StageSpec& stage, int restart, Random& random) {
  std::vector<int> order = stage.objects;
  if (restart == 0) return order;
  for (int i = static_cast<int>(order.size()) - 1; i > 0; --i) std::swap(order[i], order[random.Below(i + 1)]);
  return order;
}

}  // namespace

RestartResult FurnishRestart(const SolveInput& input, const StageSpec& stage, const PartialLayout& before,
                             int restart) {
  Random random(RestartSeed(input.settings, stage, restart));
  const std::vector<Vec2<double>> centers = ZoneCenters(input.scene, before.placed, before.layout);
  const SceneCosts costs = BindCosts(input, centers);
  const SearchInput search_input{input.scene,    input.partners,   centers, input.solver,
                                 input.keep_out, &input.walk_grid, {},      input.Over()};
  LayoutSearch search(search_input, MakeProblem(input, costs, stage, before), before.layout);

  search.Construct(OrderOf(stage, restart, random), restart == 0 ? 0.0 : kFurnishNoise, random);
  search.Sweep(stage.objects, kFurnishSweeps, CandidateDensity{}, random);
  const Layout swept = search.layout();
  const double swept_score = search.Score();
  search.Descend(stage.objects, {.max_evaluations = 40, .relative_tolerance = 1e-3, .absolute_tolerance = 1e-4});
  double score = search.Score();
  if (score > swept_score) {
    search.set_layout(swept);
    score = swept_score;
  }
  RestartResult result{restart, score, search.evaluations(), before};
  for (int object : stage.objects) result.state.Place(object, search.layout()[object]);
  return result;
}

}  // namespace flair::optimizer
