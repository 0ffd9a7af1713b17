// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/stage.h"

#include <algorithm>
#include <utility>

#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/stages/floor_stages.h"
#include "optimizer_worker/stages/patterns.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/pose.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

constexpr int kNotRun = -1;

bool IsFloorPiece(const Object& object) { return object.kind == ObjectKind::kFloor; }

bool Belongs(const Object& object, StageKind kind, int zone) {
  const bool tertiary = object.role == ObjectRole::kTertiary;
  switch (kind) {
    case StageKind::kPrimary:
      return object.role == ObjectRole::kPrimary && IsFloorPiece(object);
    case StageKind::kSecondary:
      return object.role != ObjectRole::kPrimary && object.zone == zone &&
             (tertiary ? IsSolid(object) : IsFloorPiece(object));
    case StageKind::kPolish:
      return tertiary ? IsSolid(object) : IsFloorPiece(object);
    case StageKind::kTertiary:
      return tertiary ? !IsSolid(object) : !IsFloorPiece(object);
  }
  return false;
}

// `starts` differ in where the patterns of groups stand, best first.
RestartResult RunKind(const SolveInput& input, const StageSpec& stage, const std::vector<PartialLayout>& starts,
                      int restart) {
  const PartialLayout& before = starts[restart % starts.size()];
  switch (stage.kind) {
    case StageKind::kPolish: {
      const bool later_round = restart % kRestartsPerBranch >= RestartsOf(input.settings, stage);
      return PolishRestart(input, stage, before, restart, later_round ? 1 : kPolishPasses);
    }
    case StageKind::kTertiary:
      return TertiaryRestart(input, stage, before, restart);
    case StageKind::kPrimary:
    case StageKind::kSecondary:
      break;
  }
  return FurnishRestart(input, stage, before, restart);
}

// Poses leave a restart as they would arrive in a message (no -0, headings in [0, 2 pi)), so that it does not matter to
// the last bit where it ran.
RestartResult RunRestart(const SolveInput& input, const StageSpec& stage, const std::vector<PartialLayout>& starts,
                         int restart) {
  RestartResult result = RunKind(input, stage, starts, restart);
  for (int object : stage.objects) {
    const Pose<double>& pose = result.state.layout[object];
    result.state.Place(object, {pose.x_m + 0.0, pose.y_m + 0.0, WrapHeading(pose.theta_rad)});
  }
  return result;
}

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

std::string_view StageName(StageKind kind) {
  switch (kind) {
    case StageKind::kPrimary:
      return "primary";
    case StageKind::kSecondary:
      return "secondary";
    case StageKind::kPolish:
      return "polish";
    case StageKind::kTertiary:
      return "tertiary";
  }
  return "";
}

PartialLayout::PartialLayout(const Scene& scene) : layout(scene.objects.size()), placed(scene.objects.size(), 0) {
  for (size_t i = 0; i < layout.size(); ++i) layout[i] = FarAway(static_cast<int>(i));
}

void PartialLayout::Place(int object, const Pose<double>& pose) {
  layout[object] = pose;
  placed[object] = 1;
}

StageSpec MakeStage(const Scene& scene, StageKind kind, int zone) {
  StageSpec stage{kind, zone, {}};
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) {
    if (Belongs(scene.objects[i], kind, zone)) stage.objects.push_back(i);
  }
  return stage;
}

int RestartsOf(const SolveSettings& settings, const StageSpec& stage) {
  if (settings.max_restarts > 0) return settings.max_restarts;
  const int objects = static_cast<int>(stage.objects.size());
  switch (stage.kind) {
    case StageKind::kPrimary:
      return objects <= 1 ? 4 : 8;
    case StageKind::kSecondary:
      return 2;
    case StageKind::kPolish:
      return 1;
    case StageKind::kTertiary:
      return 1;
  }
  return 1;
}

uint64_t RestartSeed(const SolveSettings& settings, const StageSpec& stage, int restart) {
  const uint64_t seed = CombineSeeds({settings.seed, static_cast<uint64_t>(stage.kind),
                                      static_cast<uint64_t>(stage.zone + 1), static_cast<uint64_t>(restart)});
  return seed >> 11;  // fits SolvedLayout's 53 bits
}

absl::StatusOr<std::vector<RestartResult>> RunRestarts(const SolveInput& input, const StageSpec& stage,
                                                       const PartialLayout& before, int first, int count) {
  std::vector<RestartResult> results(count, RestartResult{kNotRun, 0, 0, before});
  const bool furnishes = stage.kind == StageKind::kPrimary || stage.kind == StageKind::kSecondary;
  const std::vector<PartialLayout> starts =
      furnishes ? PlacePatterns(input, stage, before) : std::vector<PartialLayout>{before};
  RETURN_IF_ERROR(runtime::ForEach({input.settings.threads, {}}, count, [&](int i) {
    // The first one runs in any case: a stage that has begun has a result.
    if (input.Cancelled() || (i > 0 && input.OutOfTime())) return;
    results[i] = RunRestart(input, stage, starts, first + i);
  }));
  if (input.Cancelled()) {
    return absl::CancelledError(std::string("cancelled in stage ") + std::string(StageName(stage.kind)));
  }
  std::erase_if(results, [](const RestartResult& result) { return result.restart == kNotRun; });
  return results;
}

size_t BestOf(const std::vector<RestartResult>& results) {
  size_t best = 0;
  for (size_t i = 1; i < results.size(); ++i) {
    if (results[i].score < results[best].score) best = i;
  }
  return best;
}

Problem MakeProblem(const SolveInput& input, const SceneCosts& costs, const StageSpec& stage,
                    const PartialLayout& before) {
  std::vector<char> free(input.scene.objects.size(), 0), there = before.placed;
  for (int object : stage.objects) free[object] = there[object] = 1;
  std::vector<int> active;
  for (int t = 0; t < static_cast<int>(costs.terms.size()); ++t) {
    const Term& term = costs.terms[t];
    if (!CountsIn(term, stage.kind)) continue;
    const auto is_free = [&](int object) { return free[object] != 0; };
    const auto is_there = [&](int object) { return there[object] != 0; };
    const std::span<const int> reads = term.cost->objects();
    if (std::none_of(reads.begin(), reads.end(), is_free)) continue;
    if (std::all_of(term.required.begin(), term.required.end(), is_there)) active.push_back(t);
  }
  Problem problem(costs.terms, std::move(active), static_cast<int>(input.scene.objects.size()));
  for (int i = 0; i < static_cast<int>(before.placed.size()); ++i) {
    if (before.placed[i]) problem.SetPlaced(i, true);
  }
  return problem;
}

SearchInput SearchInputOf(const SolveInput& input, std::span<const Vec2<double>> zone_centers,
                          const evaluation::WalkGrid* walk_grid) {
  return {input.scene, input.partners, zone_centers, input.solver, input.keep_out, walk_grid,
          {},          input.Over(),   &input.linked};
}

PartialLayout StartOf(const SolveInput& input) {
  PartialLayout start(input.scene);
  for (const Pin& pin : input.pins) start.Place(pin.object, pin.pose);
  return start;
}

StageSpec FreeStage(const SolveInput& input, StageKind kind, int zone) {
  StageSpec stage{kind, zone, {}};
  const bool furnishes = kind == StageKind::kPrimary || kind == StageKind::kSecondary;
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    const int leader = furnishes ? input.groups.LeaderOf(input.scene, i) : i;
    if (Belongs(input.scene.objects[leader], kind, zone)) stage.objects.push_back(i);
  }
  std::erase_if(stage.objects, [&input](int object) { return input.pinned[object] != 0; });
  return stage;
}

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
