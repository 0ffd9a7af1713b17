// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "absl/status/statusor.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {
namespace {

// About what a missed constraint costs.
constexpr double kMostOfWholeRoom = 1;

class Collector {
 public:
  Collector(const SolveInput& input, SceneCosts& costs) : input_(input), costs_(costs) {}

  void Edges(std::span<const Vec2<double>> zone_centers) {
    const BindContext context{input_.scene, zone_centers, &input_.linked};
    costs_.dropped.resize(input_.graph.edges_size());
    for (int e = 0; e < input_.graph.edges_size(); ++e) {
      const v1::ConstraintEdge& edge = input_.graph.edges(e);
      absl::StatusOr<std::unique_ptr<Cost>> cost = Bind(edge, context);
      if (!cost.ok()) {
        costs_.dropped[e] = std::string(cost.status().message());
        continue;
      }
      Term& term = costs_.terms.emplace_back();
      term.cost = *std::move(cost);
      term.required = NamedObjects(edge, input_.scene);
      term.factor = edge.weight() > 0 ? edge.weight() : 1.0;
      // A call about many objects stands for as many wishes: four chairs round a table are more than one of them.
      term.weight = term.factor * std::max(1, static_cast<int>(term.required.size()) / 2);
      term.edge = e;
      term.robust = true;
      term.name = edge.type();
    }
  }

  void Floor(std::span<const Vec2<double>> zone_centers) {
    const Scene& scene = input_.scene;
    const LambdaValues& lambdas = input_.settings.lambdas;
    std::vector<int> primaries;
    for (int i = 0; i < Count(); ++i) {
      const Object& object = scene.objects[i];
      if (object.kind != ObjectKind::kFloor || object.walk_over) continue;
      Hard(kInBoundsTerm, lambdas.in_bounds, InBounds(scene, i));
      Hard(kDoorClearTerm, lambdas.no_overlap * lambdas.door_overlap, DoorClear(scene, i));
      Soft(kAlignedTerm, 1, Aligned(scene, i));
      if (lambdas.wall_attraction_divisor > 0) {
        Soft(kWallAttractionTerm, 1 / lambdas.wall_attraction_divisor, WallAttraction(scene, i));
      }
      if (object.role != ObjectRole::kTertiary) Soft(kZoneTerm, lambdas.zone, ZoneAffinity(scene, i, zone_centers));
      if (object.role == ObjectRole::kPrimary) primaries.push_back(i);
    }
    if (primaries.size() > 1) Soft(kBalancedTerm, lambdas.balanced, Balanced(scene, primaries));
  }

  void Tertiaries() {
    const Scene& scene = input_.scene;
    const LambdaValues& lambdas = input_.settings.lambdas;
    for (int i = 0; i < Count(); ++i) {
      const Object& object = scene.objects[i];
      if (object.kind == ObjectKind::kFloor && !object.walk_over) continue;
      Hard(kInBoundsTerm, lambdas.tertiary_in_bounds, InBounds(scene, i));
      Hard(kOnWallTerm, lambdas.on_wall, OnWall(scene, i));
      Soft(kAlignedTerm, 1, Aligned(scene, i));
    }
  }

  void Pairs() {
    for (int a = 0; a < Count(); ++a) {
      for (int b = a + 1; b < Count(); ++b) {
        std::unique_ptr<Cost> cost = NoOverlapPair(input_.scene, a, b);
        if (!cost) continue;
        Hard(kNoOverlapTerm, input_.settings.lambdas.no_overlap, std::move(cost));
        costs_.terms.back().reach_m = ReachOf(a, b);
      }
    }
  }

 private:
  int Count() const { return static_cast<int>(input_.scene.objects.size()); }

  // Circles round the two do not meet; a little more than that, for rounding.
  double ReachOf(int a, int b) const {
    const auto reach = [&](int object) { return CircumscribedRadius(input_.scene.objects[object].footprint); };
    return (reach(a) + reach(b)) * (1 + 1e-12);
  }
  void Hard(const char* name, double factor, std::unique_ptr<Cost> cost) { Add(name, factor, std::move(cost), true); }
  void Soft(const char* name, double factor, std::unique_ptr<Cost> cost) { Add(name, factor, std::move(cost), false); }
  void Add(const char* name, double factor, std::unique_ptr<Cost> cost, bool hard) {
    if (!cost) return;
    Term& term = costs_.terms.emplace_back();
    term.required.assign(cost->objects().begin(), cost->objects().end());
    term.cost = std::move(cost);
    term.factor = factor;
    term.weight = hard && factor < kHardFactor ? factor * kHardFactor : factor;
    term.hard = hard;
    term.name = name;
    // A crooked piece counts like a missed constraint.
    term.robust = term.name == kAlignedTerm;
    if (term.name == kBalancedTerm || term.name == kZoneTerm) term.most = kMostOfWholeRoom;
  }

  const SolveInput& input_;
  SceneCosts& costs_;
};

}  // namespace

SceneCosts BindCosts(const SolveInput& input, std::span<const Vec2<double>> zone_centers) {
  SceneCosts costs;
  Collector collector(input, costs);
  collector.Edges(zone_centers);
  collector.Floor(zone_centers);
  collector.Tertiaries();
  collector.Pairs();
  return costs;
}

SceneCosts BindCosts(const SolveInput& input, const PartialLayout& state) {
  return BindCosts(input, ZoneCenters(input.scene, state.placed, state.layout));
}

bool CountsIn(const Term& term, StageKind stage) {
  if (term.name == kBalancedTerm) return stage == StageKind::kPrimary;
  if (term.name == kZoneTerm || term.name == kInZoneCall) return stage != StageKind::kPrimary;
  return true;
}

}  // namespace flair::optimizer
